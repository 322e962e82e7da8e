// SPDX-License-Identifier: LGPL-2.1-or-later
#include "point_sums.h"

#include "ricochet/peridynamics/plane_sums.h"

#include <Eigen/Geometry>

#include <array>
#include <sstream>
#include <utility>

namespace ricochet
{
PointEnergies point_energies(const MPI_Comm communicator, const Lattice &lattice,
                             const LatticeArrays &a, const double mass, const double dt)
{
  PlaneSums<2> sums(lattice.box().n[0]);
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        auto &sum = sums[lattice.plane_of(p)];
        if (lattice.free(p))
        {
          const Vector3 v(a.velocity[0][p], a.velocity[1][p], a.velocity[2][p]),
              f(a.force[0][p], a.force[1][p], a.force[2][p]);
          sum[0] += 0.5 * mass * v.dot(v + dt / mass * f);
        }
        sum[1] += a.energy[p];
      });
  const auto sum = sums.total(communicator);
  return {sum[0], sum[1]};
}

Momenta point_momenta(const MPI_Comm communicator, const Lattice &lattice, const LatticeArrays &a,
                      const double mass)
{
  PlaneSums<6> sums(lattice.box().n[0]);
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (!lattice.free(p))
          return;
        const Vector3 linear = mass * Vector3(a.velocity[0][p], a.velocity[1][p], a.velocity[2][p]);
        const Vector3 angular =
            Vector3(a.position[0][p], a.position[1][p], a.position[2][p]).cross(linear);
        for (int d = 0; d < 3; ++d)
        {
          sums[lattice.plane_of(p)][d] += linear[d];
          sums[lattice.plane_of(p)][3 + d] += angular[d];
        }
      });
  const auto sum = sums.total(communicator);
  return {{sum[0], sum[1], sum[2]}, {sum[3], sum[4], sum[5]}};
}

std::string first_point_not_finite(const Lattice &lattice, const LatticeArrays &a)
{
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
  std::string found;
  if (sum == 0.)
    return found;
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        for (const auto &[name, field] : fields)
          if (found.empty() && !Vector3(field[0][p], field[1][p], field[2][p]).allFinite())
          {
            const auto c = lattice.coordinates(p);
            std::ostringstream text;
            text << "The " << name << " of point (" << c[0] << ", " << c[1] << ", " << c[2] << ")";
            found = text.str();
          }
      });
  return found;
}
} // namespace ricochet
