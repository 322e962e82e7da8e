// SPDX-License-Identifier: LGPL-2.1-or-later
// What calibration computes cell by cell against what the points of a strained plate really feel.
#include "support/coupled_plate.h"

#include "ricochet/base/voigt.h"

#include "ricochet/coupling/cell_forces.h"

#include <gtest/gtest.h>

#include <set>

namespace ricochet::tests
{
namespace
{
/// N_a at the centre of a sub-cube.
double shape(const int corner, const int sub)
{
  double value = 1.;
  for (int d = 0; d < 3; ++d)
    value *= ((corner >> d) & 1) == ((sub >> d) & 1) ? 0.75 : 0.25;
  return value;
}

/// Forces at the corners of every slaved cell, six unit strains, by both ways.
void compare(const CoupledSample &sample)
{
  PlateModel plate(sample);
  CellForces forces(*plate.points, {plate.points->material().bulk_modulus,
                                    plate.points->material().shear_modulus});
  const auto &lattice = plate.points->lattice();
  const double strain = 1e-7;
  const double unit   = PlateModel::modulus * plate.edge() * plate.edge();
  for (int k = 0; k < n_unit_strains; ++k)
  {
    const auto F = strained(k, strain);
    plate.deform([&](const Vector3 &X) -> Vector3 { return F * X; });
    double worst = 0., largest = 0.;
    plate.zone->for_each_cell(
        [&](const Zone::Cell &cell)
        {
          // Under 23 and 12 the mirrored half is strained the other way; only far from the plane
          // are the points then in a uniform field.
          if (!plate.zone->is_slaved(cell) ||
              (sample.mirror_y && (k == voigt::number[1][2] || k == voigt::number[0][1]) &&
               cell[1] < 3))
            return;
          const auto &entry =
              forces.of(cell, cell_pattern(*plate.zone, cell, lattice.stencil(), sample.mirror_y));
          for (int corner = 0; corner < 8; ++corner)
            for (int d = 0; d < 3; ++d)
            {
              double sum = 0.;
              for (int sub = 0; sub < 8; ++sub)
                sum += shape(corner, sub) *
                       plate.points->state().arrays.force[d][lattice.index(
                           2 * cell[0] + (sub & 1), 2 * cell[1] + ((sub >> 1) & 1),
                           2 * cell[2] + (sub >> 2))];
              worst   = std::max(worst, std::abs(sum / strain - entry.corner[corner][d][k]) / unit);
              largest = std::max(largest, std::abs(entry.corner[corner][d][k]) / unit);
            }
        });
    EXPECT_GT(largest, 0.01) << "strain " << k;
    EXPECT_LE(worst, 1e-6) << "strain " << k;
  }
}

TEST(CellForces, AreThoseOfThePointsInABlock)
{
  CoupledSample sample;
  sample.communicator = MPI_COMM_SELF;
  compare(sample);
}

TEST(CellForces, AreThoseOfThePointsInAColumnWithFreeSurfaces)
{
  CoupledSample sample;
  sample.communicator = MPI_COMM_SELF;
  sample.n_cells      = {12, 12, 6};
  sample.zone         = {{4, 4, 0}, {8, 8, 6}};
  compare(sample);
}

TEST(CellForces, AreThoseOfThePointsBesideAMirror)
{
  CoupledSample sample;
  sample.communicator = MPI_COMM_SELF;
  sample.n_cells      = {12, 10, 8};
  sample.zone         = {{4, 0, 2}, {8, 4, 6}};
  sample.mirror_y     = true;
  compare(sample);
}

TEST(CellForces, AreThoseOfThePointsInAPlainBlend)
{
  CoupledSample sample;
  sample.communicator    = MPI_COMM_SELF;
  sample.coupling.method = CouplingMethod::energy_blend;
  sample.n_cells         = {18, 18, 18};
  sample.zone            = {{7, 7, 7}, {11, 11, 11}};
  compare(sample);
}

TEST(CellForces, StressShareFallsFromThePadToTheHalo)
{
  CoupledSample sample;
  sample.communicator = MPI_COMM_SELF;
  PlateModel plate(sample);
  CellForces forces(*plate.points, {plate.points->material().bulk_modulus,
                                    plate.points->material().shear_modulus});
  const auto share = [&](const Zone::Cell &cell)
  {
    return forces
        .of(cell, cell_pattern(*plate.zone, cell, plate.points->lattice().stencil(), false))
        .stress_share;
  };
  const double pad = share({4, 6, 6}), halo = share({3, 6, 6});
  EXPECT_LT(pad, 1.);
  EXPECT_GT(pad, 0.5);
  EXPECT_LT(halo, 0.5);
  EXPECT_GT(halo, 0.);
}

Stencil stencil_of(const double horizon_ratio)
{
  return make_stencil(1e-3, horizon_ratio, InfluenceFunction::cone);
}

TEST(CellPattern, IsTheSameWhereBondsAreTheSame)
{
  const Stencil stencil = stencil_of(3.);
  Zone zone({30, 30, 20}, stencil.reach);
  zone.grow({{{10, 10, 7}, {20, 20, 13}}});
  const auto of = [&](const Zone &around, const Zone::Cell &cell, const bool is_mirrored)
  { return cell_pattern(around, cell, stencil, is_mirrored); };
  const auto pattern = [&](const Zone::Cell &cell) { return of(zone, cell, false); };
  EXPECT_EQ(pattern({14, 9, 10}), pattern({15, 9, 10}));  // along a face of the zone
  EXPECT_NE(pattern({14, 9, 10}), pattern({14, 8, 10}));  // another layer
  EXPECT_NE(pattern({14, 9, 10}), pattern({14, 20, 10})); // another side
  EXPECT_NE(pattern({14, 9, 10}), pattern({10, 9, 10}));  // near an edge of the zone
  std::set<CellPattern> corners;
  for (int corner = 0; corner < 8; ++corner)
    corners.insert(pattern({corner & 1 ? 20 : 9, corner & 2 ? 20 : 9, corner & 4 ? 13 : 6}));
  EXPECT_EQ(corners.size(), 8u);

  Zone near_face({30, 30, 20}, stencil.reach);
  near_face.grow({{{2, 10, 7}, {20, 20, 13}}});
  EXPECT_NE(of(near_face, {1, 14, 10}, false), // one cell from the plate's face
            of(zone, {9, 14, 10}, false));
  // Beside a mirror there is no face.
  Zone mirrored({30, 30, 20}, stencil.reach);
  mirrored.grow({{{10, 0, 7}, {20, 8, 13}}});
  EXPECT_EQ(of(mirrored, {9, 1, 10}, true), of(mirrored, {9, 2, 10}, true));
  EXPECT_NE(of(mirrored, {9, 1, 10}, false), of(mirrored, {9, 2, 10}, false));
}

/// How far away another cell, or a face, may be and still make a pattern another one, in cells.
struct Sight
{
  int cells, faces;
};

Sight sight_of(const double horizon_ratio)
{
  const Stencil stencil = stencil_of(horizon_ratio);
  constexpr int n = 40, centre = 20, layer = centre - 1;
  Zone plain({n, n, n}, stencil.reach);
  plain.grow({{{centre, 0, 0}, {n, n, n}}});
  const auto pattern = cell_pattern(plain, {layer, centre, centre}, stencil, false);
  Sight sight{0, 0};
  for (int away = 1; away < centre - 1; ++away)
  {
    // A zone that ends so far away beside the cell, and a plate that does.
    Zone other({n, n, n}, stencil.reach);
    other.grow({{{centre, 0, 0}, {n, centre + away, n}}});
    if (cell_pattern(other, {layer, centre, centre}, stencil, false) != pattern)
      sight.cells = away;
    Zone small({n, n, centre + away}, stencil.reach);
    small.grow({{{centre, 0, 0}, {n, n, centre + away}}});
    if (cell_pattern(small, {layer, centre, centre}, stencil, false) != pattern)
      sight.faces = away;
  }
  return sight;
}

TEST(CellPattern, SeesAsFarAsTheHorizonAsks)
{
  // With cells of two spacings: the bonds of a cell's points and those of their ends; the zone that
  // ends in front of a cell is seen one cell farther. For faces also two horizons.
  const auto sight_at = [](const double horizon_ratio)
  {
    const Stencil stencil = stencil_of(horizon_ratio);
    const auto cells      = [](const int points) { return (points + 1) / 2; };
    return std::pair(cells(2 * stencil.reach),
                     cells(2 * stencil.reach + static_cast<int>(2. * horizon_ratio)));
  };
  for (const double horizon_ratio : {2., 3., 4., 5.})
  {
    const auto sight          = sight_of(horizon_ratio);
    const auto [cells, faces] = sight_at(horizon_ratio);
    EXPECT_EQ(sight.cells, cells) << "horizon of " << horizon_ratio << " spacings";
    EXPECT_EQ(sight.faces, faces) << "horizon of " << horizon_ratio << " spacings";
  }
}

TEST(CellPattern, MendingReachesOverTwoHorizons)
{
  EXPECT_EQ(mending_range(stencil_of(3.)), 6);
  EXPECT_EQ(mending_range(stencil_of(4.)), 8);
  EXPECT_EQ(mending_range(make_stencil(0.73e-3, 3., InfluenceFunction::constant)), 6);
  EXPECT_EQ(mending_range(stencil_of(2.5)), 5);
}
} // namespace
} // namespace ricochet::tests
