// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/damage_report.h"

#include "ricochet/base/mpi_tools.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace ricochet
{
namespace
{
/// Bonds of a box full of points, as the model computes it. What finite elements carry counts as if
/// it had bonds: shares are then the same whatever the zone.
double bonds_of_box(const Lattice &lattice)
{
  const auto &n = lattice.box().n;
  double bonds  = 0.;
  for (const auto &o : lattice.stencil().offsets)
  {
    // Half of the bonds of the mirrored box, which has twice as many points across.
    const double across =
        lattice.box().mirror_y ? n[1] - 0.5 * std::abs(o.y) : n[1] - std::abs(o.y);
    bonds += std::max(0, n[0] - std::abs(o.x)) * std::max(0., across) *
             std::max(0, n[2] - std::abs(o.z));
  }
  return bonds;
}

/// The same of a box with holes and notches: by hand, each bond at both of its ends. Collective.
double bonds_around_cutouts(const Lattice &lattice, const MPI_Comm communicator)
{
  const auto &n      = lattice.box().n;
  const auto is_left = [&](const std::array<int, 3> &c)
  {
    return c[0] >= 0 && c[0] < n[0] && c[1] < n[1] && (c[1] >= 0 || lattice.box().mirror_y) &&
           c[2] >= 0 && c[2] < n[2] && !lattice.is_cut_out(c);
  };
  double ends = 0.;
  for (int x = lattice.first_plane(); x < lattice.first_plane() + lattice.n_planes(); ++x)
    for (int y = 0; y < n[1]; ++y)
      for (int z = 0; z < n[2]; ++z)
        for (std::size_t k = 0; k < lattice.stencil().offsets.size() && is_left({x, y, z}); ++k)
          for (const int sign : {-1, 1})
          {
            const auto &o = lattice.stencil().offsets[k];
            ends += is_left({x + sign * o.x, y + sign * o.y, z + sign * o.z}) ? 1. : 0.;
          }
  MPI_Allreduce(MPI_IN_PLACE, &ends, 1, MPI_DOUBLE, MPI_SUM, communicator);
  return 0.5 * ends;
}

/// Where all points of a layer, from first to last along z, were cut out, a map has no value; the
/// mean is over those that are left.
void leave_out_cutouts(const Lattice &lattice, const int first, const int last,
                       std::vector<float> &values)
{
  const auto &n = lattice.box().n;
  for (int x = 0; x < n[0] && lattice.has_cutouts(); ++x)
    for (int y = 0; y < n[1]; ++y)
    {
      int n_left = 0;
      for (int z = first; z <= last; ++z)
        n_left += lattice.is_cut_out({x, y, z}) ? 0 : 1;
      float &value = values[static_cast<std::size_t>(x) * n[1] + y];
      value        = n_left == 0 ? std::numeric_limits<float>::quiet_NaN()
                                 : value * static_cast<float>(last - first + 1) / n_left;
    }
}

void sum_on_first_rank(const MPI_Comm communicator, std::vector<float> &values)
{
  // Every value is zero on all ranks but its owner's.
  MPI_Reduce(rank_in(communicator) == 0 ? MPI_IN_PLACE : values.data(), values.data(),
             static_cast<int>(values.size()), MPI_FLOAT, MPI_SUM, 0, communicator);
}
} // namespace

DamageReport::DamageReport(const MPI_Comm communicator, const Simulation &simulation) :
  communicator_(communicator), simulation_(simulation)
{
  for (const auto &plate : simulation.plates())
  {
    const Lattice &lattice = plate->lattice();
    n_bonds_.push_back(plate->multiplicity() * plate->count_bonds());
    n_bonds_everywhere_.push_back(lattice.has_cutouts()
                                      ? bonds_around_cutouts(lattice, communicator)
                                      : bonds_of_box(lattice));
  }
}

double DamageReport::n_bonds() const
{
  return std::accumulate(n_bonds_.begin(), n_bonds_.end(), 0.);
}

std::vector<PlateDamage> DamageReport::plates() const
{
  std::vector<PlateDamage> damage;
  for (std::size_t i = 0; i < n_bonds_.size(); ++i)
  {
    const auto &plate      = *simulation_.plates()[i];
    const Lattice &lattice = plate.lattice();
    const int top          = lattice.box().n[2] - 1;
    double n[2]            = {0., 0.};
    lattice.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const auto c = lattice.coordinates(p);
          if ((c[2] == top || c[2] == 0) && plate.damage(p) > damaged_share)
            n[c[2] == 0] += 1.;
        });
    MPI_Allreduce(MPI_IN_PLACE, n, 2, MPI_DOUBLE, MPI_SUM, communicator_);
    const double area       = plate.multiplicity() * std::pow(lattice.box().spacing, 2);
    const double broken     = plate.count_sound_bonds() - plate.count_bonds();
    const auto *const joint = simulation_.joint_above(i);
    damage.push_back({broken / n_bonds_everywhere_[i], area * n[0], area * n[1],
                      joint != nullptr ? joint->broken_share() : -1.});
  }
  return damage;
}

std::vector<DamageMap> DamageReport::maps() const
{
  std::vector<DamageMap> maps;
  for (std::size_t i = 0; i < n_bonds_.size(); ++i)
  {
    const auto &plate      = *simulation_.plates()[i];
    const Lattice &lattice = plate.lattice();
    const auto &box        = lattice.box();
    DamageMap map{static_cast<int>(i) + 1,
                  box.n[0],
                  box.n[1],
                  box.spacing,
                  {box.corner.x(), box.corner.y()},
                  box.mirror_y,
                  {},
                  {},
                  {}};
    for (auto *const values : {&map.front, &map.rear, &map.mean})
      values->assign(static_cast<std::size_t>(box.n[0]) * box.n[1], 0.F);
    lattice.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const auto c         = lattice.coordinates(p);
          const auto damage    = static_cast<float>(plate.damage(p));
          const std::size_t at = static_cast<std::size_t>(c[0]) * box.n[1] + c[1];
          map.mean[at] += damage / box.n[2];
          if (c[2] == box.n[2] - 1)
            map.front[at] = damage;
          if (c[2] == 0)
            map.rear[at] = damage;
        });
    for (auto *const values : {&map.front, &map.rear, &map.mean})
      sum_on_first_rank(communicator_, *values);
    leave_out_cutouts(lattice, box.n[2] - 1, box.n[2] - 1, map.front);
    leave_out_cutouts(lattice, 0, 0, map.rear);
    leave_out_cutouts(lattice, 0, box.n[2] - 1, map.mean);
    maps.push_back(std::move(map));
  }
  return maps;
}
} // namespace ricochet
