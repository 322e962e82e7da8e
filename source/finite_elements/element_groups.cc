// SPDX-License-Identifier: LGPL-2.1-or-later
#include "element_groups.h"

#include "shear_stress.h"

#include "ricochet/base/elastic_constants.h"
#include "ricochet/base/voigt.h"

#include <algorithm>

namespace ricochet
{
namespace
{
enum
{
  shared_moduli,
  own_tensors
};

constexpr int block_size = ElementHistory::block_size;

/// S += C : E with the mean of the Gauss points' tensors.
void add_mean_product(const HexTensors &tensors, const int lane, const Eigen::Matrix3d &E,
                      Eigen::Matrix3d &S)
{
  const auto add = [&](const int to, const int from, const double share)
  {
    const double value =
        share * (voigt::is_shear(from) ? 2. : 1.) * E(voigt::row[from], voigt::column[from]);
    S(voigt::row[to], voigt::column[to]) += value;
    if (voigt::is_shear(to))
      S(voigt::column[to], voigt::row[to]) += value;
  };
  for (const auto &c : tensors.c)
    for (int i = 0, k = 0; i < voigt::n; ++i)
      for (int j = i; j < voigt::n; ++j, ++k)
      {
        add(i, j, c[k][lane] / 8.);
        if (j > i)
          add(j, i, c[k][lane] / 8.);
      }
}
} // namespace

ElementGroups::ElementGroups(const HexMesh &mesh, const FiniteElementMaterial &material,
                             const Quadrature quadrature, const double hourglass_coefficient,
                             const HexKernel &kernel) :
  mesh_(mesh),
  material_(material), quadrature_(quadrature), hourglass_coefficient_(hourglass_coefficient),
  kernel_(kernel), dissipated_before_(mesh.elements().size(), 0.)
{
  set_active(std::vector<char>(mesh.elements().size(), 0));
}

void ElementGroups::set_active(const std::vector<char> &active)
{
  active_ = active;
  if (memories_.empty())
    memories_ = memories();
  for (std::size_t e = 0; e < memories_.size(); ++e)
    if (!active_[e])
    {
      dissipated_before_[e] += memories_[e].dissipated;
      memories_[e] = {};
    }
  set_stiffness({});
}

void ElementGroups::set_stiffness(const std::vector<ElementStiffness> &stiffness)
{
  std::vector<const ElementStiffness *> own(active_.size(), nullptr);
  for (const auto &entry : stiffness)
    own[entry.element] = &entry;
  if (memories_.empty())
    memories_ = memories();
  sort(own);
  for (auto &group : groups_)
    fill_blocks(group);
  fill_tensors(own);
  restore_histories();
}

void ElementGroups::sort(const std::vector<const ElementStiffness *> &own)
{
  groups_ = {};
  place_.clear();
  std::vector<int> numbers;
  for (std::size_t e = 0; e < active_.size(); ++e)
  {
    const int number = !active_[e] ? -1 : own[e] == nullptr ? shared_moduli : own_tensors;
    place_.push_back({number, 0});
    numbers.push_back(std::max(number, 0));
    if (number < 0)
      continue;
    auto &group         = groups_[number];
    place_.back().index = static_cast<int>(group.elements.size());
    group.elements.push_back(static_cast<int>(e));
  }
  order_ = mesh_.summation_order(numbers);
}

void ElementGroups::fill_blocks(Group &group) const
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

void ElementGroups::fill_tensors(const std::vector<const ElementStiffness *> &own)
{
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
}

int ElementGroups::n_gauss_points(const int group) const
{
  return group == shared_moduli && quadrature_ == Quadrature::one_point ? 1 : 8;
}

void ElementGroups::start_relaxation(const double dt)
{
  check_series(material_.relaxation);
  check_step(material_.relaxation, dt);
  branches_.clear();
  for (const auto &branch : material_.relaxation)
    branches_.push_back(maxwell_step(branch, dt));
  memories_.clear();
  restore_histories();
}

ElementGroups::Memories ElementGroups::memories() const
{
  Memories memories(relaxes() ? place_.size() : 0);
  for (std::size_t e = 0; e < memories.size(); ++e)
    if (const auto &place = place_[e]; place.group >= 0)
      memories[e] = groups_[place.group].history.memory(place.index);
  return memories;
}

void ElementGroups::restore_histories()
{
  if (!relaxes())
    return;
  for (const int number : {shared_moduli, own_tensors})
    groups_[number].history =
        ElementHistory(groups_[number].elements.size(), n_gauss_points(number),
                       static_cast<int>(branches_.size()));
  for (std::size_t e = 0; e < memories_.size(); ++e)
    if (const auto &place = place_[e]; place.group >= 0)
      groups_[place.group].history.restore(place.index, memories_[e]);
}

HexGroup ElementGroups::view(const Group &group) const
{
  const double k =
      hourglass_coefficient_ * youngs_modulus(material_.bulk_modulus, material_.shear_modulus);
  const double tetragonal = material_.anisotropy.tetragonal * material_.shear_modulus;
  return {group.blocks.data(),
          group.tensors.empty() ? nullptr : group.tensors.data(),
          static_cast<int64_t>(group.elements.size()),
          material_.bulk_modulus - 2. / 3. * tetragonal,
          tetragonal,
          material_.anisotropy.diagonal * material_.shear_modulus,
          k / 48.,
          k / 144.};
}

HexKernel::ForceLoop ElementGroups::loop(const int group, const bool energy) const
{
  const auto &k = kernel_;
  return group == own_tensors ? (energy ? k.own_tensors_and_energy : k.own_tensors)
         : quadrature_ == Quadrature::one_point ? (energy ? k.one_point_and_energy : k.one_point)
                                                : (energy ? k.integrated_and_energy : k.integrated);
}

HexKernel::RelaxingForceLoop ElementGroups::relaxing_loop(const int group, const bool energy) const
{
  const auto &k = kernel_;
  return group == own_tensors
             ? (energy ? k.relaxing_own_tensors_and_energy : k.relaxing_own_tensors)
         : quadrature_ == Quadrature::one_point
             ? (energy ? k.relaxing_one_point_and_energy : k.relaxing_one_point)
             : (energy ? k.relaxing_integrated_and_energy : k.relaxing_integrated);
}

void ElementGroups::add_forces(const std::vector<double> &position, std::vector<double> &force,
                               const bool energy, const bool is_step)
{
  for (const int number : {shared_moduli, own_tensors})
  {
    auto &group = groups_[number];
    const HexArrays arrays{position.data(), force.data(), group.strain_energy.data(),
                           group.hourglass_energy.data()};
    if (!relaxes())
    {
      loop(number, energy)(arrays, view(group));
      continue;
    }
    ElementHistory kept = is_step ? ElementHistory() : group.history;
    relaxing_loop(number,
                  energy)(arrays, view(group),
                          {static_cast<int>(branches_.size()), branches_.data(),
                           group.history.values(), group.shear.data(), group.history.dissipated()});
    if (!is_step)
      group.history = std::move(kept);
  }
  if (is_step)
    memories_.clear();
  mesh_.add_to_owners(force.data(), order_);
}

double ElementGroups::strain_energy(const int element) const
{
  const auto &place = place_[element];
  return place.group < 0 ? 0. : groups_[place.group].strain_energy[place.index];
}

double ElementGroups::hourglass_energy(const int element) const
{
  const auto &place = place_[element];
  return place.group < 0 ? 0. : groups_[place.group].hourglass_energy[place.index];
}

void ElementGroups::add_energies(Energies &sums) const
{
  const auto add = [](const std::vector<double> &energies, ExactSum &sum)
  {
    for (const double energy : energies)
      sum.add(energy);
  };
  for (const auto &group : groups_)
  {
    add(group.strain_energy, sums.strain);
    add(group.hourglass_energy, sums.hourglass);
    add(group.history.dissipated(), sums.viscous);
  }
  add(dissipated_before_, sums.viscous);
}

Eigen::Matrix3d ElementGroups::history(const int element, const int branch) const
{
  const auto &place = place_[element];
  if (place.group < 0 || !relaxes())
    return Eigen::Matrix3d::Zero();
  const auto &step    = branches_[branch];
  const auto &history = groups_[place.group].history;
  return step.decay * history.back_strain(place.index, branch) +
         (1. - step.decay - step.lag) * history.strain(place.index);
}

Eigen::Matrix3d ElementGroups::back_strain(const int element, const int branch) const
{
  const auto &place = place_[element];
  if (place.group < 0 || !relaxes())
    return Eigen::Matrix3d::Zero();
  return groups_[place.group].history.back_strain(place.index, branch);
}

Eigen::Matrix3d ElementGroups::stress(const int element, const Eigen::Matrix3d &E) const
{
  const auto &place       = place_[element];
  Eigen::Matrix3d relaxed = Eigen::Matrix3d::Zero(); // sum lambda_k E_b,k
  for (std::size_t k = 0; k < branches_.size(); ++k)
    relaxed += branches_[k].share * back_strain(element, static_cast<int>(k));
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  if (place.group == shared_moduli)
  {
    S = material_.bulk_modulus * E.trace() * Eigen::Matrix3d::Identity() +
        shear_stress(material_, E);
    if (relaxes())
      S -= shear_stress(material_, relaxed);
  }
  else if (place.group == own_tensors)
  {
    const auto &group = groups_[own_tensors];
    const int block = place.index / block_size, lane = place.index % block_size;
    add_mean_product(group.tensors[block], lane, E, S);
    if (relaxes())
      add_mean_product(group.shear[block], lane, -relaxed, S);
  }
  return S;
}
} // namespace ricochet
