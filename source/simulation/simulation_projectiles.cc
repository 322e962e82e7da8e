// SPDX-License-Identifier: LGPL-2.1-or-later
// The projectiles of a Simulation.
#include "ricochet/base/exceptions.h"
#include "ricochet/contact/friction_laws.h"
#include "ricochet/simulation/simulation.h"

#include <sstream>

namespace ricochet
{
void Simulation::build_projectiles()
{
  const auto &contact = scene_.contact;
  friction_law_       = make_friction_law(contact.friction);
  std::vector<PlateContact> plate_contacts;
  for (const auto *const plate : plates())
  {
    const double spacing = plate->lattice().box().spacing;
    RigidContact::Parameters parameters;
    parameters.stiffness = contact_stiffness(*plate);
    parameters.shank_force =
        contact.shank_contact_fraction * contact.shank_resistance * spacing * spacing;
    parameters.regularisation_speed = contact.regularisation_speed;
    plate_contacts.push_back({parameters, spacing, plate->lattice().box().n[0]});
  }
  for (std::size_t i = 0; i < scene_.n_projectiles(); ++i)
  {
    const auto &impact = scene_.impact_at(i);
    projectiles_.push_back(
        make_projectile(communicator_, scene_.with_only(i), *friction_law_, plate_contacts));
    const auto &body = *projectiles_.back();
    initial_energy_ += impact.spin != 0.
                           ? body.multiplicity() * body.energies(/*dt=*/0.).kinetic
                           : 0.5 * scene_.projectile_at(i).mass * impact.speed * impact.speed;
    refuse_overlap(i);
  }
}

/// A projectile must start outside all plates.
void Simulation::refuse_overlap(const std::size_t projectile)
{
  const auto reactions     = projectiles_[projectile]->add_contact_forces(plates(), /*dt=*/0.);
  const std::string number = projectile == 0 ? "" : " " + std::to_string(projectile + 1);
  for (std::size_t i = 0; i < plates_.size(); ++i)
    if (const auto &reaction = reactions[i]; reaction.n_touching > 0.)
    {
      std::ostringstream message;
      message << (number.empty() ? "The projectile" : "Projectile" + number)
              << " starts inside plate " << i + 1 << ": it touches " << reaction.n_touching
              << " points, the deepest by " << 1e3 * reaction.deepest << " mm. Raise 'Impact"
              << number << "/Clearance' or move 'Impact" << number << "/Entry point'.";
      throw InputError(message.str());
    }
}
} // namespace ricochet
