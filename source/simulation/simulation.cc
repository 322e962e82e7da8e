// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/simulation.h"

#include "element_frame.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/contact/friction_laws.h"
#include "ricochet/dynamics/coupled_time_step.h"
#include "ricochet/dynamics/stable_time_step.h"

#include <chrono>
#include <cmath>
#include <sstream>

namespace ricochet
{
namespace
{
Vector3 at(double *const field[3], const std::ptrdiff_t p)
{
  return {field[0][p], field[1][p], field[2][p]};
}

double youngs_modulus(const PeridynamicMaterial &m)
{
  return 9. * m.bulk_modulus * m.shear_modulus / (3. * m.bulk_modulus + m.shear_modulus);
}

std::string broadcast(const MPI_Comm communicator, std::string text, const int root)
{
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, root, communicator);
  text.resize(length);
  MPI_Bcast(text.data(), length, MPI_CHAR, root, communicator);
  return text;
}

} // namespace

double critical_stretch(const MaterialParameters &material, const Stencil &stencil)
{
  if (material.critical_stretch > 0.)
    return material.critical_stretch;
  return std::sqrt(material.energy_release / fracture_energy_per_squared_stretch(
                                                 stencil, bond_law(material.bond_model),
                                                 material.bulk_modulus, material.shear_modulus));
}

Simulation::Simulation(const MPI_Comm communicator, const Scene &scene) :
  communicator_(communicator), scene_(scene), multiplicity_(scene.symmetric ? 2. : 1.)
{
  build_plates();
  build_projectile();
  choose_time_step();
}

const MaterialParameters &Simulation::material(const std::size_t plate) const
{
  for (const auto &material : scene_.materials)
    if (material.name == scene_.plates[plate].material)
      return material;
  throw InputError("There is no material '" + scene_.plates[plate].material + "'.");
}

double Simulation::critical_stretch(const std::size_t plate) const
{
  return plates_[plate]->material().critical_stretch;
}

void Simulation::build_plates()
{
  double top = 0.;
  for (std::size_t i = 0; i < scene_.plates.size(); ++i)
  {
    const auto &plate    = scene_.plates[i];
    const auto &material = this->material(i);
    const Stencil stencil =
        make_stencil(plate.spacing, plate.horizon_ratio, plate.influence_function);

    Lattice::Box box;
    box.spacing  = plate.spacing;
    box.mirror_y = scene_.symmetric;
    box.n        = lattice_points(scene_, plate);
    top -= i == 0 ? 0. : plate.gap;
    const double thickness = box.n[2] * plate.spacing;
    box.corner = {0., scene_.symmetric ? 0. : -0.5 * box.n[1] * plate.spacing, top - thickness};
    top -= thickness;

    const auto &law = bond_law(material.bond_model);
    const PeridynamicMaterial bonds{&law,
                                    material.density,
                                    material.bulk_modulus,
                                    material.shear_modulus,
                                    ricochet::critical_stretch(material, stencil),
                                    relaxing_within(material.relaxation, scene_.time.end_time),
                                    material.history_precision};
    zones_.push_back(plate_zone(scene_, plate, box, stencil));
    auto &zone = zones_.back();
    plates_.push_back(std::make_unique<PeridynamicBody>(communicator_, static_cast<int>(i), box,
                                                        stencil, bonds, Lattice::Mask{}, nullptr,
                                                        zone.zone.get()));
    coupled_plates_.push_back(nullptr);
    adaptive_zones_.push_back(nullptr);
    if (zone.zone == nullptr)
      continue;
    coupled_plates_.back() =
        std::make_unique<CoupledPlate>(communicator_, *plates_.back(), *zone.zone, zone.options);
    adaptive_zones_.back() = std::make_unique<AdaptiveZone>(
        communicator_, *coupled_plates_.back(),
        // Contact with a deformable projectile remembers points.
        AdaptiveZone::Parameters{scene_.zone.conversion_stretch * bonds.critical_stretch,
                                 scene_.zone.adaptive,
                                 scene_.projectile.model == ProjectileModel::rigid});
  }
}

void Simulation::build_projectile()
{
  const auto &impact = scene_.impact;
  initial_energy_    = 0.5 * scene_.projectile.mass * impact.speed * impact.speed;

  const auto &contact = scene_.contact;
  friction_law_       = make_friction_law(contact.friction);
  std::vector<PlateContact> plate_contacts;
  for (const auto &plate : plates_)
  {
    const double spacing = plate->lattice().box().spacing;
    RigidContact::Parameters parameters;
    parameters.stiffness = contact.stiffness_factor * youngs_modulus(plate->material()) * spacing;
    parameters.shank_force =
        contact.shank_contact_fraction * contact.shank_resistance * spacing * spacing;
    parameters.regularisation_speed = contact.regularisation_speed;
    plate_contacts.push_back({parameters, spacing, plate->lattice().box().n[0]});
    fractures_.emplace_back(*plate, scene_.symmetric);
  }
  projectile_ = make_projectile(communicator_, scene_, *friction_law_, plate_contacts);
  for (std::size_t i = 0; i < plates_.size(); ++i)
    if (const auto reaction = projectile_->touch(i, *plates_[i]); reaction.n_touching > 0.)
    {
      std::ostringstream message;
      message << "The projectile starts inside plate " << i + 1 << ": it touches "
              << reaction.n_touching << " points, the deepest by " << 1e3 * reaction.deepest
              << " mm. Raise 'Impact/Clearance' or move 'Impact/Entry point'.";
      throw InputError(message.str());
    }
  ShortRangeContact::Friction friction;
  if (contact.debris_friction > 0.)
    friction = {friction_law_.get(), contact.debris_friction,
                contact.regularisation_speed};
  debris_ = std::make_unique<ShortRangeContact>(communicator_, plates_, contact.debris_factor,
                                                scene_.symmetric, contact.search, friction);
}

void Simulation::choose_time_step()
{
  double largest = 0.;
  std::vector<double> elastic_seconds;
  time_step_info_ = {};
  for (std::size_t i = 0; i < plates_.size(); ++i)
  {
    const auto &plate    = plates_[i];
    const auto estimate  = coupled_plates_[i]
                               ? estimate_largest_frequency(communicator_, *coupled_plates_[i])
                               : estimate_largest_frequency(communicator_, *plate);
    const double spacing = plate->lattice().box().spacing;
    const double stiffness =
        scene_.contact.stiffness_factor * youngs_modulus(plate->material()) * spacing;
    const double contact = stiffness / plate->point_mass() + debris_->squared_frequency(*plate);
    if (estimate.squared_frequency + contact > largest)
    {
      largest                       = estimate.squared_frequency + contact;
      time_step_info_.frequency     = std::sqrt(estimate.squared_frequency);
      time_step_info_.contact_share = contact / largest;
    }
    elastic_seconds.push_back(estimate.seconds_per_force);
    frequencies_.push_back(estimate);
  }
  time_step_info_.seconds_per_step += projectile_->seconds_per_step();
  const double safety           = scene_.time.safety_factor;
  time_step_info_.plates_dt     = safety * 2. / std::sqrt(largest);
  time_step_info_.projectile_dt = safety * 2. / std::sqrt(projectile_->squared_frequency());
  dt_ = std::min(time_step_info_.plates_dt, time_step_info_.projectile_dt);
  start_relaxation(elastic_seconds);
}

void Simulation::start_relaxation(const std::vector<double> &elastic_seconds)
{
  for (std::size_t i = 0; i < plates_.size(); ++i)
  {
    double seconds = elastic_seconds[i];
    auto &plate    = *plates_[i];
    if (coupled_plates_[i])
      coupled_plates_[i]->start_relaxation(dt_);
    else
      plate.start_relaxation(dt_);
    if (plate.history() != nullptr)
    {
      // A step at rest, timed when the memory has been touched, and then from no history again.
      for (int call = 0; call < 4; ++call)
      {
        const auto start = std::chrono::steady_clock::now();
        plate.update_ghosts();
        plate.evaluate(/*breaking=*/false, /*energy=*/false);
        seconds = std::max(
            elastic_seconds[i],
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      }
      plate.start_relaxation(dt_);
      MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    }
    time_step_info_.seconds_per_step += seconds;
  }
}

void Simulation::evaluate(const bool energy)
{
  reaction_ = {};
  projectile_->begin(energy);
  for (std::size_t i = 0; i < plates_.size(); ++i)
  {
    plates_[i]->update_ghosts();
    if (adaptive_zones_[i] &&
        adaptive_zones_[i]->update(time_, dt_,
                                   projectile_->bounding_box().second.x() + zones_[i].growth_ahead))
    {
      plates_[i]->update_ghosts();
      debris_->bodies_changed();
    }
    plates_[i]->evaluate(/*breaking=*/true, energy);
    fractures_[i].record(dt_);
    const auto part = projectile_->touch(i, *plates_[i]);
    reaction_.normal += part.normal;
    reaction_.friction += part.friction;
    reaction_.shank += part.shank;
    reaction_.moment += part.moment;
    reaction_.friction_moment += part.friction_moment;
    reaction_.energy += part.energy;
    reaction_.n_touching += part.n_touching;
    reaction_.on_elements = reaction_.on_elements || part.on_elements;
    reaction_.deepest =
        std::max(reaction_.deepest, part.deepest / plates_[i]->lattice().box().spacing);
  }
  debris_->evaluate(dt_);
  for (const auto &coupled_plate : coupled_plates_)
    if (coupled_plate)
      coupled_plate->evaluate(energy);
}

void Simulation::advance()
{
  for (std::size_t i = 0; i < plates_.size(); ++i)
  {
    plates_[i]->advance(dt_, dt_);
    if (coupled_plates_[i])
    {
      coupled_plates_[i]->advance(dt_, dt_);
      coupled_plates_[i]->lead();
    }
    projectile_->record_work(i, *plates_[i], dt_);
  }
  debris_->record_work(dt_);
  projectile_->advance(reaction_, dt_);
  time_ += dt_;
  ++step_;
}

std::pair<Vector3, Vector3> Simulation::target_box() const
{
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::max()), high = -low;
  for (const auto &plate : plates_)
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
  EnergyBalance e{};
  e.initial             = initial_energy_;
  const auto projectile = projectile_->energies(reaction_, dt_);
  e.projectile          = projectile.kinetic;
  e.elastic             = projectile.elastic;
  e.contact             = reaction_.energy;
  e.debris              = debris_->energy();
  e.friction            = -projectile_->friction_work();
  e.debris_friction     = 0. - debris_->friction_work(); // not -0
  for (std::size_t i = 0; i < plates_.size(); ++i)
  {
    if (coupled_plates_[i])
    {
      const auto sum = coupled_plates_[i]->energies(dt_);
      e.kinetic += multiplicity_ * sum.kinetic;
      e.strain += multiplicity_ * sum.strain;
      e.hourglass += multiplicity_ * sum.hourglass;
      e.viscous += multiplicity_ * sum.viscous;
      e.absorbed += multiplicity_ * sum.absorbed;
      e.conversion += multiplicity_ * adaptive_zones_[i]->loss();
    }
    else
    {
      const auto sum = plates_[i]->energies(dt_);
      e.kinetic += multiplicity_ * sum.kinetic;
      e.strain += multiplicity_ * sum.strain;
      e.viscous += multiplicity_ * sum.viscous;
    }
    e.fracture += fractures_[i].total(communicator_).energy;
  }
  return e;
}

MomentumBalance Simulation::momenta() const
{
  const auto projectile = projectile_->momenta();
  MomentumBalance m{projectile.linear, projectile.angular};
  for (std::size_t i = 0; i < plates_.size(); ++i)
  {
    const auto sum = coupled_plates_[i] ? coupled_plates_[i]->momenta() : plates_[i]->momenta();
    m.linear += multiplicity_ * sum.linear;
    m.angular += multiplicity_ * sum.angular;
  }
  if (scene_.symmetric)
    m.linear.y() = m.angular.x() = m.angular.z() = 0.;
  return m;
}

std::pair<Vector3, Vector3> Simulation::damaged_box(const std::size_t plate) const
{
  // Lower corner and minus the upper one.
  constexpr double largest = std::numeric_limits<double>::max();
  std::array<double, 6> corners{largest, largest, largest, largest, largest, largest};
  const auto &body       = *plates_[plate];
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
  MPI_Allreduce(MPI_IN_PLACE, corners.data(), 6, MPI_DOUBLE, MPI_MIN, communicator_);
  return {{corners[0], corners[1], corners[2]}, {-corners[3], -corners[4], -corners[5]}};
}

double Simulation::broken_bonds() const
{
  double n = 0.;
  for (const auto &fracture : fractures_)
    n += fracture.total(communicator_).n_bonds;
  return n;
}

double Simulation::n_points() const
{
  double n = 0.;
  for (const auto &plate : plates_)
    n += static_cast<double>(plate->lattice().n_owned_points());
  MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return n;
}

double Simulation::n_bonds() const
{
  double n = 0.;
  for (const auto &plate : plates_)
    n += plate->count_bonds();
  return n;
}

void Simulation::check_finite() const
{
  if (!projectile_->motion().position.allFinite()) // the same on all ranks
    throw RunError("The position of the projectile is not a number at " +
                   std::to_string(1e6 * time_) + " us (step " + std::to_string(step_) +
                   "). Lower 'Time/Safety factor' or 'Contact/Stiffness factor'.");
  // The first bad point in the order plate, lattice index is reported, by the lowest rank that has
  // one.
  std::string complaint;
  for (std::size_t i = 0; i < plates_.size() && complaint.empty(); ++i)
  {
    const Lattice &lattice = plates_[i]->lattice();
    const auto &a          = plates_[i]->state().arrays;
    const std::array<std::pair<const char *, double *const *>, 3> fields{
        {{"position", a.position}, {"velocity", a.velocity}, {"force", a.force}}};
    // A sum that is finite has finite terms, and needs no branches.
    double sum = 0.;
    for (const auto &range : lattice.owned_ranges())
      for (const auto &[name, field] : fields)
        for (int d = 0; d < 3; ++d)
          for (std::ptrdiff_t p = range.first * Lattice::block_size;
               p < range.last * Lattice::block_size; ++p)
            sum += 0. * field[d][p];
    if (sum == 0.)
      continue;
    lattice.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          for (const auto &[name, field] : fields)
            if (complaint.empty() && !at(field, p).allFinite())
            {
              const auto c = lattice.coordinates(p);
              std::ostringstream message;
              message << "The " << name << " of point (" << c[0] << ", " << c[1] << ", " << c[2]
                      << ") of plate " << i + 1 << " is not a number at " << 1e6 * time_
                      << " us (step " << step_
                      << "). Lower 'Time/Safety factor' or 'Contact/Stiffness factor'.";
              complaint = message.str();
            }
        });
  }
  for (std::size_t i = 0; i < plates_.size() && complaint.empty(); ++i)
    if (coupled_plates_[i])
    {
      const auto &elements = coupled_plates_[i]->elements();
      for (int node = 0; node < elements.mesh().n_owned_nodes() && complaint.empty(); ++node)
        for (const auto *field : {&elements.position(), &elements.velocity(), &elements.force()})
          if (!Vector3((*field)[3 * node], (*field)[3 * node + 1], (*field)[3 * node + 2])
                   .allFinite())
          {
            std::ostringstream message;
            message << "The motion of the element node at ("
                    << 1e3 * elements.mesh().reference_position(node).transpose()
                    << ") mm of plate " << i + 1 << " is not a number at " << 1e6 * time_
                    << " us (step " << step_
                    << "). Lower 'Time/Safety factor' or choose another 'Coupling/Method'.";
            complaint = message.str();
          }
    }
  int rank, bad;
  MPI_Comm_rank(communicator_, &rank);
  const int mine = complaint.empty() ? std::numeric_limits<int>::max() : rank;
  MPI_Allreduce(&mine, &bad, 1, MPI_INT, MPI_MIN, communicator_);
  if (bad == std::numeric_limits<int>::max())
    return;
  throw RunError(broadcast(communicator_, complaint, bad));
}

std::string Simulation::describe_fastest_point() const
{
  struct
  {
    double speed;
    int rank;
  } fastest{-1., 0};
  std::ostringstream text;
  for (std::size_t i = 0; i < plates_.size(); ++i)
    plates_[i]->lattice().for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          if (const double speed = at(plates_[i]->state().arrays.velocity, p).norm();
              speed > fastest.speed)
          {
            const auto c  = plates_[i]->lattice().coordinates(p);
            fastest.speed = speed;
            text.str("");
            text << "Point (" << c[0] << ", " << c[1] << ", " << c[2] << ") of plate " << i + 1
                 << " is the fastest, at " << speed << " m/s.";
          }
        });
  MPI_Comm_rank(communicator_, &fastest.rank);
  MPI_Allreduce(MPI_IN_PLACE, &fastest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, communicator_);
  return broadcast(communicator_, text.str(), fastest.rank);
}

PointFrame Simulation::points() const
{
  PointFrame frame;
  for (std::size_t i = 0; i < plates_.size(); ++i)
  {
    const auto &plate      = *plates_[i];
    const Lattice &lattice = plate.lattice();
    const auto &a          = plate.state().arrays;
    lattice.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const auto c    = lattice.coordinates(p);
          const Vector3 x = at(a.position, p), X = lattice.reference_position(c);
          frame.position.push_back(x);
          frame.displacement.push_back(x - X);
          frame.velocity.push_back(at(a.velocity, p));
          frame.damage.push_back(plate.damage(p));
          frame.dilatation.push_back(a.theta[p]);
          frame.body.push_back(static_cast<int>(i) + 1);
          frame.in_section.push_back(X.y() > 0. && X.y() < lattice.box().spacing);
        });
  }
  return frame;
}

ElementFrame Simulation::elements() const
{
  ElementFrame frame;
  for (std::size_t i = 0; i < plates_.size(); ++i)
    if (coupled_plates_[i])
      add_elements(*coupled_plates_[i], static_cast<int>(i) + 1, frame);
  return frame;
}
} // namespace ricochet
