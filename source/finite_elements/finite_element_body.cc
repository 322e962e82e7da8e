// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/finite_element_body.h"

#include "ricochet/base/exceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>

namespace ricochet
{
namespace
{
enum
{
  shared_moduli,
  own_tensors
};

constexpr int block_size = 8;

Vector3 at(const std::vector<double> &values, const int node)
{
  return {values[3 * node], values[3 * node + 1], values[3 * node + 2]};
}

double youngs_modulus(const FiniteElementMaterial &m)
{
  return 9. * m.bulk_modulus * m.shear_modulus / (3. * m.bulk_modulus + m.shear_modulus);
}

/// Row and column of a symmetric matrix in the order of HexTensors.
constexpr int voigt_row[6] = {0, 1, 2, 1, 0, 0}, voigt_column[6] = {0, 1, 2, 2, 2, 1};

/// S += C : E with the mean of the Gauss points' tensors.
void add_mean_product(const HexTensors &tensors, const int lane, const Eigen::Matrix3d &E,
                      Eigen::Matrix3d &S)
{
  const auto add = [&](const int to, const int from, const double share)
  {
    const double value = share * (from < 3 ? 1. : 2.) * E(voigt_row[from], voigt_column[from]);
    S(voigt_row[to], voigt_column[to]) += value;
    if (to >= 3)
      S(voigt_column[to], voigt_row[to]) += value;
  };
  for (const auto &c : tensors.c)
    for (int i = 0, k = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j, ++k)
      {
        add(i, j, c[k][lane] / 8.);
        if (j > i)
          add(j, i, c[k][lane] / 8.);
      }
}
} // namespace

FiniteElementBody::FiniteElementBody(const MPI_Comm communicator, const HexMesh::Box &box,
                                     const FiniteElementMaterial &material) :
  FiniteElementBody(communicator, box, material, Options())
{
}

FiniteElementBody::FiniteElementBody(const MPI_Comm communicator, const HexMesh::Box &box,
                                     const FiniteElementMaterial &material,
                                     const Options &options) :
  communicator_(communicator),
  mesh_(communicator, box), material_(material), options_(options),
  kernel_(hex_kernel(options.instruction_set)), position_(mesh_.reference()),
  velocity_(position_.size(), 0.), force_(position_.size(), 0.)
{
  if (kernel_ == nullptr)
    throw InputError(std::string("This processor does not have the instruction set '") +
                     options.instruction_set + "'.");
  set_active(options.active);
}

void FiniteElementBody::set_active(const std::function<bool(const Vector3 &)> &active)
{
  active_.clear();
  for (const auto &element : mesh_.elements())
    active_.push_back(!active || active(mesh_.centre(element)));
  auto past = memories();
  for (std::size_t e = 0; e < past.size(); ++e)
    if (!active_[e])
    {
      dissipated_elsewhere_ += past[e].dissipated;
      past[e] = {};
    }
  set_stiffness({});
  past_ = std::move(past); // for the tensors that may follow: Gauss points stay apart
  lump_mass();
}

void FiniteElementBody::lump_mass()
{
  mass_.clear();
  inverse_mass_.clear();
  std::vector<double> mass(force_.size(), 0.);
  for (std::size_t e = 0; e < active_.size(); ++e)
    if (active_[e])
    {
      const auto &element = mesh_.elements()[e];
      const double share  = material_.density * element.edge * element.edge * element.edge / 8.;
      for (const int node : element.nodes)
        for (int d = 0; d < 3; ++d)
          mass[3 * node + d] += share;
    }
  mesh_.add_to_owners(mass.data());
  for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
  {
    mass_.push_back(mass[3 * node]);
    for (int d = 0; d < 3; ++d)
      inverse_mass_.push_back(mass_[node] > 0. ? 1. / mass_[node] : 0.);
    if (mesh_.on_mirror_plane(node))
      inverse_mass_[3 * node + 1] = 0.;
  }
  for (const int entry : fixed_)
    inverse_mass_[entry] = 0.;
}

void FiniteElementBody::set_consistent_mass(const std::vector<int> &elements,
                                            const int points_per_edge)
{
  spread_        = elements;
  // n masses in the middles of the parts of an edge couple its ends by (s, 1/2 - s).
  const double n = points_per_edge;
  spread_share_  = (4. * n * n - 1.) / (12. * n * n);
  spreads_mass_  = true;
  // An owned node may be a corner of other ranks' elements only.
  std::vector<double> touched(force_.size(), 0.);
  for (const int e : spread_)
    for (const int node : mesh_.elements()[e].nodes)
      touched[3 * node] = 1.;
  mesh_.add_to_owners(touched.data());
  spread_nodes_.clear();
  for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    if (touched[3 * node] > 0.)
      spread_nodes_.push_back(node);
  spread_force_.assign(3 * spread_nodes_.size(), 0.);
  acceleration_.assign(force_.size(), 0.);
  find_spread_momentum();
}

void FiniteElementBody::velocity_changed()
{
  if (spreads_mass_)
    find_spread_momentum();
}

/// Adds (M_L - M_C) a of the elements of consistent mass, the product of those of edges.
void FiniteElementBody::add_mass_difference(const std::vector<double> &acceleration,
                                            std::vector<double> &force) const
{
  const double near = spread_share_, far = 0.5 - spread_share_;
  for (const int e : spread_)
  {
    const auto &element = mesh_.elements()[e];
    const double mass   = material_.density * element.edge * element.edge * element.edge;
    for (int d = 0; d < 3; ++d)
    {
      double a[8], c[8];
      for (int corner = 0; corner < 8; ++corner)
        c[corner] = a[corner] = acceleration[3 * element.nodes[corner] + d];
      for (const int axis : {1, 2, 4})
        for (int corner = 0; corner < 8; ++corner)
          if ((corner & axis) == 0)
          {
            const double low = c[corner], high = c[corner | axis];
            c[corner]        = near * low + far * high;
            c[corner | axis] = far * low + near * high;
          }
      for (int corner = 0; corner < 8; ++corner)
        force[3 * element.nodes[corner] + d] += mass * (a[corner] / 8. - c[corner]);
    }
  }
}

void FiniteElementBody::correct_mass()
{
  if (!spreads_mass_)
    return;
  for (std::size_t i = 0; i < inverse_mass_.size(); ++i)
    acceleration_[i] = force_[i] * inverse_mass_[i];
  mesh_.update_ghosts(acceleration_.data());
  for (std::size_t i = 0; i < spread_nodes_.size(); ++i)
    for (int d = 0; d < 3; ++d)
      spread_force_[3 * i + d] = force_[3 * spread_nodes_[i] + d];
  // Ghost entries of the force are zero since it went to its owners.
  add_mass_difference(acceleration_, force_);
  mesh_.add_to_owners(force_.data());
}

/// Solves (2 M_L - M_C) y = M_L v by conjugate gradients, M_eff v = M_L y: all eigenvalues of the
/// scaled matrix lie between 1 and 2.
void FiniteElementBody::find_spread_momentum()
{
  const std::size_t n = inverse_mass_.size();
  const auto product  = [&](const std::vector<double> &x, const std::vector<double> &y)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < n; ++i)
      sum += x[i] * y[i];
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return sum;
  };
  std::vector<double> y(force_.size(), 0.), residual(y), direction(y), image(y), scaled(y);
  std::copy_n(velocity_.begin(), n, y.begin());
  const auto apply = [&](std::vector<double> &x, std::vector<double> &result)
  {
    mesh_.update_ghosts(x.data());
    std::fill(result.begin(), result.end(), 0.);
    add_mass_difference(x, result);
    mesh_.add_to_owners(result.data());
    for (std::size_t i = 0; i < n; ++i)
      result[i] = inverse_mass_[i] > 0. ? result[i] + mass_[i / 3] * x[i] : 0.;
  };
  apply(y, image);
  for (std::size_t i = 0; i < n; ++i)
  {
    residual[i]  = inverse_mass_[i] > 0. ? mass_[i / 3] * velocity_[i] - image[i] : 0.;
    direction[i] = scaled[i] = residual[i] * inverse_mass_[i];
  }
  double rho            = product(residual, scaled);
  const double enough   = 1e-26 * rho;
  constexpr int maximum = 60;
  for (int iteration = 0; iteration < maximum && rho > enough; ++iteration)
  {
    apply(direction, image);
    const double alpha = rho / product(direction, image);
    for (std::size_t i = 0; i < n; ++i)
    {
      y[i] += alpha * direction[i];
      residual[i] -= alpha * image[i];
      scaled[i] = residual[i] * inverse_mass_[i];
    }
    const double next = product(residual, scaled), beta = next / rho;
    rho = next;
    for (std::size_t i = 0; i < n; ++i)
      direction[i] = scaled[i] + beta * direction[i];
  }
  // Rows of both matrices have the same sums: with what is left of the residual the total is the
  // sum of M_L v to the last bit, however well y has converged.
  spread_momentum_.clear();
  for (const int node : spread_nodes_)
    for (int d = 0; d < 3; ++d)
      spread_momentum_.push_back(mass_[node] * y[3 * node + d] + residual[3 * node + d]);
}

void FiniteElementBody::set_stiffness(const std::vector<ElementStiffness> &stiffness)
{
  std::vector<const ElementStiffness *> own(active_.size(), nullptr);
  for (const auto &entry : stiffness)
    own[entry.element] = &entry;
  const auto past = past_.empty() ? memories() : past_;
  past_.clear();
  for (int number : {shared_moduli, own_tensors})
  {
    groups_[number] = {};
    groups_[number].n_points =
        number == shared_moduli && options_.quadrature == Quadrature::one_point ? 1 : 8;
  }
  place_.clear();
  for (std::size_t e = 0; e < active_.size(); ++e)
  {
    const int number = !active_[e] ? -1 : own[e] == nullptr ? shared_moduli : own_tensors;
    place_.push_back({number, 0});
    if (number < 0)
      continue;
    auto &group         = groups_[number];
    place_.back().index = static_cast<int>(group.elements.size());
    group.elements.push_back(static_cast<int>(e));
  }
  for (auto &group : groups_)
    fill(group);

  auto &group = groups_[own_tensors];
  group.tensors.assign(group.blocks.size(), HexTensors{});
  group.shear = group.tensors;
  for (std::size_t i = 0; i < group.elements.size(); ++i)
    for (int point = 0; point < 8; ++point)
      for (int k = 0; k < HexTensors::n_entries; ++k)
      {
        group.tensors[i / block_size].c[point][k][i % block_size] =
            own[group.elements[i]]->tensors[point][k];
        group.shear[i / block_size].c[point][k][i % block_size] =
            own[group.elements[i]]->shear[point][k];
      }
  restore(past);
}

void FiniteElementBody::fill(Group &group) const
{
  const std::size_t n = group.elements.size();
  group.blocks.resize((n + block_size - 1) / block_size);
  group.strain_energy.assign(n, 0.);
  group.hourglass_energy.assign(n, 0.);
  for (std::size_t i = 0; i < group.blocks.size() * block_size; ++i)
  {
    const auto &element = mesh_.elements()[group.elements[std::min(i, n - 1)]];
    auto &block         = group.blocks[i / block_size];
    for (int corner = 0; corner < 8; ++corner)
      block.entry[corner][i % block_size] = 3 * element.nodes[corner];
    block.edge[i % block_size] = element.edge;
  }
}

HexGroup FiniteElementBody::view(const Group &group) const
{
  const double k = options_.hourglass_coefficient * youngs_modulus(material_);
  return {group.blocks.data(),
          group.tensors.empty() ? nullptr : group.tensors.data(),
          static_cast<int64_t>(group.elements.size()),
          material_.bulk_modulus - 2. / 3. * material_.shear_modulus,
          material_.shear_modulus,
          k / 48.,
          k / 144.};
}

void FiniteElementBody::start_relaxation(const double dt)
{
  check_series(material_.relaxation);
  check_step(material_.relaxation, dt);
  branches_.clear();
  for (const auto &branch : material_.relaxation)
    branches_.push_back(maxwell_step(branch, dt));
  restore({});
}

std::size_t FiniteElementBody::row(const Group &group, const int index, const int point,
                                   const int branch) const
{
  const std::size_t block = index / block_size;
  return ((block * group.n_points + point) * (1 + branches_.size()) + branch) * 6 * block_size +
         index % block_size;
}

std::vector<FiniteElementBody::Memory> FiniteElementBody::memories() const
{
  std::vector<Memory> memories(relaxes() ? place_.size() : 0);
  for (std::size_t e = 0; e < memories.size(); ++e)
  {
    const auto &place = place_[e];
    if (place.group < 0 || groups_[place.group].history.empty())
      continue;
    const auto &group      = groups_[place.group];
    memories[e].dissipated = group.dissipated[place.index];
    for (int point = 0; point < group.n_points; ++point)
    {
      auto &values = memories[e].points.emplace_back();
      for (std::size_t i = 0; i < 6 * (1 + branches_.size()); ++i)
        values.push_back(group.history[row(group, place.index, point, 0) + i * block_size]);
    }
  }
  return memories;
}

void FiniteElementBody::restore(const std::vector<Memory> &memories)
{
  if (!relaxes())
    return;
  for (auto &group : groups_)
  {
    group.history.assign(
        group.blocks.size() * block_size * group.n_points * 6 * (1 + branches_.size()), 0.);
    group.dissipated.assign(group.elements.size(), 0.);
  }
  for (std::size_t e = 0; e < memories.size(); ++e)
  {
    const auto &place  = place_[e];
    const auto &memory = memories[e];
    if (place.group < 0 || memory.points.empty())
      continue;
    auto &group                   = groups_[place.group];
    group.dissipated[place.index] = memory.dissipated;
    const int n_before            = static_cast<int>(memory.points.size());
    for (int point = 0; point < group.n_points; ++point)
      for (std::size_t i = 0; i < 6 * (1 + branches_.size()); ++i)
      {
        double value = 0.;
        if (n_before == group.n_points)
          value = memory.points[point][i];
        else
          for (const auto &there : memory.points)
            value += there[i] / n_before;
        group.history[row(group, place.index, point, 0) + i * block_size] = value;
      }
  }
}

Eigen::Matrix3d FiniteElementBody::history(const int element, const int branch) const
{
  const auto &place = place_[element];
  Eigen::Matrix3d E = Eigen::Matrix3d::Zero();
  if (place.group < 0 || !relaxes())
    return E;
  const auto &group = groups_[place.group];
  for (int point = 0; point < group.n_points; ++point)
    for (int i = 0; i < 6; ++i)
      E(voigt_row[i], voigt_column[i]) +=
          0.5 * group.history[row(group, place.index, point, 0) + i * block_size] / group.n_points;
  for (int i = 3; i < 6; ++i)
    E(voigt_column[i], voigt_row[i]) = E(voigt_row[i], voigt_column[i]);
  const auto &step = branches_[branch];
  return step.decay * back_strain(element, branch) + (1. - step.decay - step.lag) * E;
}

Eigen::Matrix3d FiniteElementBody::back_strain(const int element, const int branch) const
{
  const auto &place   = place_[element];
  Eigen::Matrix3d E_b = Eigen::Matrix3d::Zero();
  if (place.group < 0 || !relaxes())
    return E_b;
  const auto &group = groups_[place.group];
  for (int point = 0; point < group.n_points; ++point)
    for (int i = 0; i < 6; ++i)
    {
      const double twice =
          group.history[row(group, place.index, point, 0) + i * block_size] -
          group.history[row(group, place.index, point, 1 + branch) + i * block_size];
      E_b(voigt_row[i], voigt_column[i]) += 0.5 * twice / group.n_points;
    }
  for (int i = 3; i < 6; ++i)
    E_b(voigt_column[i], voigt_row[i]) = E_b(voigt_row[i], voigt_column[i]);
  return E_b;
}

void FiniteElementBody::set_back_strain(const int element, const int branch,
                                        const Eigen::Matrix3d &E_b)
{
  const auto &place = place_[element];
  if (place.group < 0 || !relaxes())
    return;
  auto &group = groups_[place.group];
  for (int point = 0; point < group.n_points; ++point)
    for (int i = 0; i < 6; ++i)
      group.history[row(group, place.index, point, 1 + branch) + i * block_size] =
          group.history[row(group, place.index, point, 0) + i * block_size] -
          2. * E_b(voigt_row[i], voigt_column[i]);
}

void FiniteElementBody::fix(const int node, const int component)
{
  if (node >= mesh_.n_owned_nodes())
    return;
  fixed_.push_back(3 * node + component);
  inverse_mass_[3 * node + component] = 0.;
}

void FiniteElementBody::update_ghosts()
{
  for (auto *values : {&position_, &velocity_})
  {
    mesh_.update_ghosts(values->data());
    mesh_.follow_masters(values->data());
  }
}

void FiniteElementBody::compute_internal_forces(const ForceRequest &request)
{
  const auto &[energy, is_step] = request;
  past_.clear();
  std::array<std::vector<double>, 4> kept;
  if (relaxes() && !is_step)
    kept = {groups_[0].history, groups_[1].history, groups_[0].dissipated, groups_[1].dissipated};
  std::fill(force_.begin(), force_.end(), 0.);
  for (int number : {shared_moduli, own_tensors})
  {
    auto &group = groups_[number];
    const HexArrays arrays{position_.data(), force_.data(), group.strain_energy.data(),
                           group.hourglass_energy.data()};
    const auto &k = *kernel_;
    if (relaxes())
    {
      const auto loop = number == own_tensors
                            ? (energy ? k.relaxing_own_tensors_and_energy : k.relaxing_own_tensors)
                        : options_.quadrature == Quadrature::one_point
                            ? (energy ? k.relaxing_one_point_and_energy : k.relaxing_one_point)
                            : (energy ? k.relaxing_integrated_and_energy : k.relaxing_integrated);
      loop(arrays, view(group),
           {static_cast<int>(branches_.size()), branches_.data(), group.history.data(),
            group.shear.data(), group.dissipated.data()});
      continue;
    }
    const auto loop = number == own_tensors ? (energy ? k.own_tensors_and_energy : k.own_tensors)
                      : options_.quadrature == Quadrature::one_point
                          ? (energy ? k.one_point_and_energy : k.one_point)
                          : (energy ? k.integrated_and_energy : k.integrated);
    loop(arrays, view(group));
  }
  if (relaxes() && !is_step)
    for (int number : {0, 1})
    {
      groups_[number].history    = std::move(kept[number]);
      groups_[number].dissipated = std::move(kept[2 + number]);
    }
  mesh_.add_to_owners(force_.data());
}

void FiniteElementBody::advance(const double kick, const double drift)
{
  for (std::size_t i = 0; i < spread_momentum_.size(); ++i)
    spread_momentum_[i] += kick * spread_force_[i];
  for (const auto &dashpot : dashpots_)
  {
    auto &f               = force_[dashpot.entry];
    const double undamped = f;
    f                     = damped_force(dashpot, kick);
    const double v = velocity_[dashpot.entry] + 0.5 * kick * f * inverse_mass_[dashpot.entry];
    const Vector3 impulse = kick * (undamped - f) * Vector3::Unit(dashpot.entry % 3);
    absorbed_ += kick * dashpot.coefficient * v * v;
    carried_off_.linear += impulse;
    carried_off_.angular += at(position_, dashpot.entry / 3).cross(impulse);
  }
  kernel_->advance(position_.data(), velocity_.data(), force_.data(), inverse_mass_.data(),
                   static_cast<int64_t>(inverse_mass_.size()), kick, drift);
}

Energies FiniteElementBody::energies(const double dt) const
{
  std::array<double, 5> sums{};
  const auto kinetic = [&](const int i, const double momentum)
  { return 0.5 * momentum * (velocity_[i] + dt * force_[i] * inverse_mass_[i]); };
  for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    for (int i = 3 * node; i < 3 * node + 3; ++i)
      sums[0] += kinetic(i, mass_[node] * velocity_[i]);
  for (std::size_t k = 0; k < spread_momentum_.size(); ++k)
  {
    const int node = spread_nodes_[k / 3], i = 3 * node + static_cast<int>(k % 3);
    sums[0] += kinetic(i, spread_momentum_[k] - mass_[node] * velocity_[i]);
  }
  for (const auto &group : groups_)
  {
    for (const double energy : group.strain_energy)
      sums[1] += energy;
    for (const double energy : group.hourglass_energy)
      sums[2] += energy;
  }
  for (const auto &group : groups_)
    for (const double energy : group.dissipated)
      sums[3] += energy;
  sums[3] += dissipated_elsewhere_;
  sums[4] = absorbed_;
  for (const auto &dashpot : dashpots_)
  {
    const int i         = dashpot.entry;
    const double before = velocity_[i], f = damped_force(dashpot, dt),
                 change = dt * inverse_mass_[i] * f;
    sums[0] += 0.5 * mass_[i / 3] * before * dt * inverse_mass_[i] * (f - force_[i]);
    // Up to the middle of the step.
    sums[4] += 0.5 * dt * dashpot.coefficient * before * (before + 0.5 * change);
  }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), 5, MPI_DOUBLE, MPI_SUM, communicator_);
  Energies energies;
  energies.kinetic   = sums[0];
  energies.strain    = sums[1];
  energies.hourglass = sums[2];
  energies.viscous   = sums[3];
  energies.absorbed  = sums[4];
  return energies;
}

double FiniteElementBody::squared_force() const
{
  double sum = 0.;
  for (std::size_t i = 0; i < inverse_mass_.size(); ++i)
    sum += force_[i] * force_[i] * inverse_mass_[i];
  for (std::size_t k = 0; k < spread_force_.size(); ++k)
  {
    const std::size_t i = 3 * spread_nodes_[k / 3] + k % 3;
    sum += (spread_force_[k] - force_[i]) * force_[i] * inverse_mass_[i];
  }
  return sum;
}

Momenta FiniteElementBody::momenta() const
{
  // Sums of many numbers, compared to the last bit by those who look for a drift.
  using LongVector = Eigen::Matrix<long double, 3, 1>;
  std::array<LongVector, 2> sums{carried_off_.linear.cast<long double>(),
                                 carried_off_.angular.cast<long double>()};
  const auto add = [&](const int node, const Vector3 &linear)
  {
    sums[0] += linear.cast<long double>();
    sums[1] += at(position_, node).cross(linear).cast<long double>();
  };
  std::size_t k = 0;
  for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    if (k < spread_nodes_.size() && spread_nodes_[k] == node)
      add(node, at(spread_momentum_, static_cast<int>(k++)));
    else
      add(node, mass_[node] * at(velocity_, node));
  std::array<Vector3, 2> result;
  for (int i = 0; i < 2; ++i)
  {
    result[i] = sums[i].cast<double>();
    MPI_Allreduce(MPI_IN_PLACE, result[i].data(), 3, MPI_DOUBLE, MPI_SUM, communicator_);
  }
  return {result[0], result[1]};
}

double FiniteElementBody::total_mass() const
{
  double sum = 0.;
  for (const double mass : mass_)
    sum += mass;
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return sum;
}

double FiniteElementBody::strain_energy(const int element) const
{
  const auto &place = place_[element];
  return place.group < 0 ? 0. : groups_[place.group].strain_energy[place.index];
}

double FiniteElementBody::hourglass_energy(const int element) const
{
  const auto &place = place_[element];
  return place.group < 0 ? 0. : groups_[place.group].hourglass_energy[place.index];
}

Eigen::Matrix3d FiniteElementBody::deformation_gradient(const int element) const
{
  // dN_a/dX = +-1/(4 h) in the middle
  const auto &e     = mesh_.elements()[element];
  Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
  for (int corner = 0; corner < 8; ++corner)
    for (int d = 0; d < 3; ++d)
      F.col(d) += ((corner >> d) & 1 ? 1. : -1.) / (4. * e.edge) * at(position_, e.nodes[corner]);
  return F;
}

Eigen::Matrix3d FiniteElementBody::stress(const int element) const
{
  const auto &place       = place_[element];
  const Eigen::Matrix3d F = deformation_gradient(element);
  const Eigen::Matrix3d E = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
  Eigen::Matrix3d relaxed = Eigen::Matrix3d::Zero(); // sum lambda_k E_b,k
  for (std::size_t k = 0; k < branches_.size(); ++k)
    relaxed += branches_[k].share * back_strain(element, static_cast<int>(k));
  const double mu   = material_.shear_modulus;
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  if (place.group == shared_moduli)
  {
    const double lambda = material_.bulk_modulus - 2. / 3. * mu;
    S                   = lambda * E.trace() * Eigen::Matrix3d::Identity() + 2. * mu * E;
    if (relaxes())
      S -= 2. * mu * (relaxed - relaxed.trace() / 3. * Eigen::Matrix3d::Identity());
  }
  else if (place.group == own_tensors)
  {
    const auto &group = groups_[own_tensors];
    add_mean_product(group.tensors[place.index / block_size], place.index % block_size, E, S);
    if (relaxes())
      add_mean_product(group.shear[place.index / block_size], place.index % block_size, -relaxed,
                       S);
  }
  return S;
}
} // namespace ricochet
