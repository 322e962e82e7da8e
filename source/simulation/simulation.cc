// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/simulation.h"

#include "plate_builder.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/contact/friction_laws.h"

#include <cmath>
#include <sstream>

namespace ricochet
{
namespace
{
double youngs_modulus(const PeridynamicMaterial &m)
{
  return 9. * m.bulk_modulus * m.shear_modulus / (3. * m.bulk_modulus + m.shear_modulus);
}
} // namespace

Simulation::Simulation(const MPI_Comm communicator, const Scene &scene) :
  communicator_(communicator), scene_(scene), plates_(build_plates(communicator, scene))
{
  build_projectile();
  build_contact();
  build_supports();
  choose_time_step();
  std::vector<Body *> bodies;
  for (const auto &plate : plates_)
    bodies.push_back(plate.body.get());
  bodies.push_back(projectile_.get());
  // Friction of the projectile must know what else moves the points, supports what pulls at them.
  std::vector<Interaction *> interactions{short_range_contact_.get(), projectile_contact_.get()};
  for (const auto &support : supports_)
    interactions.push_back(support.get());
  integrator_ = std::make_unique<Leapfrog>(bodies, interactions);
}

const MaterialParameters &Simulation::material(const std::size_t plate) const
{
  return material_of(scene_, scene_.plates[plate]);
}

double Simulation::critical_stretch(const std::size_t plate) const
{
  return plates_[plate].points->material().critical_stretch;
}

std::vector<const PeridynamicBody *> Simulation::plates() const
{
  std::vector<const PeridynamicBody *> points;
  for (const auto &plate : plates_)
    points.push_back(plate.points);
  return points;
}

std::vector<PeridynamicBody *> Simulation::plates()
{
  std::vector<PeridynamicBody *> points;
  for (const auto &plate : plates_)
    points.push_back(plate.points);
  return points;
}

double Simulation::contact_stiffness(const PeridynamicBody &plate) const
{
  return scene_.contact.stiffness_factor * youngs_modulus(plate.material()) *
         plate.lattice().box().spacing;
}

void Simulation::build_projectile()
{
  const auto &impact  = scene_.impact;
  const auto &contact = scene_.contact;
  initial_energy_     = 0.5 * scene_.projectile.mass * impact.speed * impact.speed;
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
  projectile_ = make_projectile(communicator_, scene_, *friction_law_, plate_contacts);
  if (impact.spin != 0.)
    initial_energy_ = projectile_->multiplicity() * projectile_->energies(/*dt=*/0.).kinetic;
  refuse_overlap();
}

/// The projectile must start outside all plates.
void Simulation::refuse_overlap()
{
  const auto reactions = projectile_->add_contact_forces(plates(), /*dt=*/0.);
  for (std::size_t i = 0; i < plates_.size(); ++i)
    if (const auto &reaction = reactions[i]; reaction.n_touching > 0.)
    {
      std::ostringstream message;
      message << "The projectile starts inside plate " << i + 1 << ": it touches "
              << reaction.n_touching << " points, the deepest by " << 1e3 * reaction.deepest
              << " mm. Raise 'Impact/Clearance' or move 'Impact/Entry point'.";
      throw InputError(message.str());
    }
}

void Simulation::build_contact()
{
  const auto &contact = scene_.contact;
  projectile_contact_ = std::make_unique<ProjectileContact>(*projectile_, plates());
  ShortRangeContact::Friction friction;
  if (contact.debris_friction > 0.)
    friction = {friction_law_.get(), contact.debris_friction, contact.regularisation_speed};
  short_range_contact_ = std::make_unique<ShortRangeContact>(
      communicator_, plates(), contact.debris_factor, scene_.symmetric, contact.search, friction);
}

void Simulation::build_supports()
{
  for (std::size_t i = 0; i < plates_.size(); ++i)
  {
    const auto &plate = scene_.plates[i];
    if (plate.clamped_sides == ClampedSides::none)
      continue;
    auto *const elements = plates_[i].coupled ? &plates_[i].coupled->elements() : nullptr;
    supports_.push_back(std::make_unique<ClampedEdges>(communicator_, *plates_[i].points, elements,
                                                       plate.clamped_sides, plate.held_width()));
  }
}

Vector3 Simulation::support_reaction() const
{
  Vector3 sum = Vector3::Zero();
  for (const auto &support : supports_)
    sum += support->reaction();
  return sum;
}

void Simulation::compute_forces(const bool energy)
{
  integrator_->compute_forces({time_, dt_, projectile_->bounding_box().second.x()}, energy);
}

void Simulation::advance()
{
  integrator_->advance(dt_);
  time_ += dt_;
  ++step_;
}

std::pair<Vector3, Vector3> Simulation::target_box() const
{
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::max()), high = -low;
  for (const auto *const plate : plates())
  {
    const auto &box   = plate->lattice().box();
    const Vector3 far = box.corner + box.spacing * Vector3(box.n[0], box.n[1], box.n[2]);
    low               = low.cwiseMin(box.corner);
    high              = high.cwiseMax(far);
    if (box.mirror_y)
      low.y() = std::min(low.y(), -far.y());
  }
  return {low, high};
}

EnergyBalance Simulation::energies() const
{
  EnergyBalance e;
  for (const auto &plate : plates_)
    e += plate.body->multiplicity() * plate.body->energies(dt_);
  const auto projectile = projectile_->multiplicity() * projectile_->energies(dt_);
  e.initial             = initial_energy_;
  e.projectile          = projectile.kinetic;
  e.drive               = projectile.drive;
  e.elastic             = projectile.strain + projectile.hourglass;
  e.contact             = projectile_contact_->energy();
  e.debris              = short_range_contact_->energy();
  e.friction            = 0. - projectile_contact_->friction_work(); // not -0
  e.debris_friction     = 0. - short_range_contact_->friction_work();
  return e;
}

MomentumBalance Simulation::momenta() const
{
  auto sum = projectile_->multiplicity() * projectile_->momenta();
  for (const auto &plate : plates_)
    sum += plate.body->multiplicity() * plate.body->momenta();
  for (const auto &support : supports_)
    sum += -1. * support->impulse();
  MomentumBalance m{sum.linear, sum.angular};
  if (scene_.symmetric)
    m.linear.y() = m.angular.x() = m.angular.z() = 0.;
  return m;
}

std::pair<Vector3, Vector3> Simulation::damaged_box(const std::size_t plate) const
{
  // Lower corner and minus the upper one.
  constexpr double largest = std::numeric_limits<double>::max();
  std::array<double, 6> corners{largest, largest, largest, largest, largest, largest};
  const auto &body       = *plates_[plate].points;
  const Lattice &lattice = body.lattice();
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (!body.is_damaged(p))
          return;
        const Vector3 X = lattice.reference_position(lattice.coordinates(p));
        for (int d = 0; d < 3; ++d)
        {
          corners[d]     = std::min(corners[d], X[d]);
          corners[3 + d] = std::min(corners[3 + d], -X[d]);
        }
      });
  if (lattice.box().mirror_y) // the other half reaches as far
    corners[1] = std::min(corners[1], corners[4]);
  MPI_Allreduce(MPI_IN_PLACE, corners.data(), 6, MPI_DOUBLE, MPI_MIN, communicator_);
  return {{corners[0], corners[1], corners[2]}, {-corners[3], -corners[4], -corners[5]}};
}

double Simulation::broken_bonds() const
{
  double n = 0.;
  for (const auto *const plate : plates())
    n += plate->multiplicity() * plate->n_broken_bonds();
  return n;
}

double Simulation::n_points() const
{
  double n = 0.;
  for (const auto *const plate : plates())
    plate->lattice().for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          if (plate->lattice().kind(p) != PointKind::contact)
            n += plate->multiplicity();
        });
  MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return n;
}

double Simulation::n_bonds() const
{
  double n = 0.;
  for (const auto *const plate : plates())
    n += plate->multiplicity() * plate->count_bonds();
  return n;
}
} // namespace ricochet
