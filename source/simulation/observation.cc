// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/observation.h"

namespace ricochet
{
namespace
{
/// As built.
PlatePlace undeformed(const PeridynamicBody &plate)
{
  const auto &box = plate.lattice().box();
  PlatePlace place{box.corner, box.corner + box.spacing * Vector3(box.n[0], box.n[1], box.n[2])};
  if (box.mirror_y)
    place.low.y() = -place.high.y();
  return place;
}

PlatePlace place_of(const PeridynamicBody &plate, const MPI_Comm communicator)
{
  const Lattice &lattice = plate.lattice();
  const auto &a          = plate.state().arrays;
  // Number, displacement, velocity: of the sound points and of all.
  PlaneSums<14> sums(lattice.box().n[0]);
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        const Vector3 X = lattice.reference_position(lattice.coordinates(p));
        auto &sum       = sums[lattice.plane_of(p)];
        for (const int start : {0, 7})
          if (start == 7 || !plate.is_damaged(p))
          {
            sum[start] += 1.;
            for (int d = 0; d < 3; ++d)
            {
              sum[start + 1 + d] += a.position[d][p] - X[d];
              sum[start + 4 + d] += a.velocity[d][p];
            }
          }
      });
  const auto all           = sums.total(communicator);
  const double *const mean = all[0] > 0. ? &all[0] : &all[7];
  PlatePlace place         = undeformed(plate);
  Vector3 displacement     = Eigen::Map<const Vector3>(mean + 1) / mean[0];
  place.velocity           = Eigen::Map<const Vector3>(mean + 4) / mean[0];
  if (lattice.box().mirror_y)
    displacement.y() = place.velocity.y() = 0.;
  place.low += displacement;
  place.high += displacement;
  return place;
}
} // namespace

std::vector<PlatePlace> plate_places(const Simulation &simulation)
{
  std::vector<PlatePlace> places;
  for (const auto *const plate : simulation.plates())
    places.push_back(place_of(*plate, simulation.communicator()));
  return places;
}

Observation observe(const Simulation &simulation, const std::size_t projectile)
{
  const auto &motion = simulation.projectile(projectile).motion();
  return {simulation.time(),
          motion.position,
          motion.velocity,
          simulation.projectile(projectile).bounding_box(),
          simulation.reaction(projectile).n_touching > 0.,
          [&simulation] { return plate_places(simulation); }};
}

OutcomeWatch watch_of(const Simulation &simulation, const std::size_t projectile)
{
  std::vector<PlatePlace> plates;
  for (const auto *const plate : simulation.plates())
    plates.push_back(undeformed(*plate));
  const Scene &scene = simulation.scene();
  return {plates, scene.impact_at(projectile).speed, scene.time.free_time};
}
} // namespace ricochet
