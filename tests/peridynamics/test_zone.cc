// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/lattice.h"
#include "ricochet/peridynamics/zone.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ricochet::tests
{
namespace
{
int distance(const Zone::Cell &a, const Zone::Cell &b) // over diagonals too
{
  int largest = 0;
  for (int d = 0; d < 3; ++d)
    largest = std::max(largest, std::abs(a[d] - b[d]));
  return largest;
}

TEST(Zone, StartsWithoutFreeCells)
{
  const Zone zone({3, 4, 5}, 2);
  EXPECT_EQ(zone.n_free_cells(), 0);
  EXPECT_EQ(zone.n_slaved_cells(), 0);
  EXPECT_EQ(zone.n_cells_in_all(), 60);
  zone.for_each_cell([&](const Zone::Cell &cell) { EXPECT_EQ(zone.layer(cell), zone.far()); });
  EXPECT_EQ(zone.kind(0, 0, 0), PointKind::absent);
}

TEST(Zone, PadAndHaloAreAsWideAsTheStencilReaches)
{
  for (const int reach : {1, 2, 3, 4, 5})
  {
    const Zone zone({4, 4, 4}, reach);
    EXPECT_EQ(zone.pad_layers(), (reach + 1) / 2);
    EXPECT_EQ(zone.slaved_layers(), 2 * ((reach + 1) / 2));
    EXPECT_EQ(zone.far(), zone.slaved_layers() + 1);
  }
  // A cell of one point needs as many as the stencil reaches, one of four is enough.
  EXPECT_EQ(Zone({4, 4, 4}, 2, BlendFunction::step, 0, 1).pad_layers(), 2);
  EXPECT_EQ(Zone({4, 4, 4}, 2, BlendFunction::step, 0, 1).slaved_layers(), 4);
  EXPECT_EQ(Zone({4, 4, 4}, 2, BlendFunction::step, 0, 4).slaved_layers(), 2);
  const Zone wide({4, 4, 4}, 2, BlendFunction::cubic, 3);
  EXPECT_EQ(wide.pad_layers(), 3);
  EXPECT_EQ(wide.slaved_layers(), 4);
}

TEST(Zone, LayersAreDistancesFromTheNearestFreeCell)
{
  Zone zone({12, 10, 9}, 4); // two layers of pad, two of halo
  const Zone::Cells a{{2, 3, 0}, {4, 5, 2}}, b{{8, 6, 6}, {9, 7, 7}};
  EXPECT_TRUE(zone.grow({a, b}));
  const auto inside = [](const Zone::Cell &cell, const Zone::Cells &box)
  {
    bool in = true;
    for (int d = 0; d < 3; ++d)
      in = in && cell[d] >= box.low[d] && cell[d] < box.high[d];
    return in;
  };
  std::int64_t n_free = 0, n_slaved = 0;
  zone.for_each_cell(
      [&](const Zone::Cell &cell)
      {
        int nearest = 100;
        zone.for_each_cell(
            [&](const Zone::Cell &other)
            {
              if (inside(other, a) || inside(other, b))
                nearest = std::min(nearest, distance(cell, other));
            });
        EXPECT_EQ(zone.layer(cell), std::min(nearest, zone.far()));
        EXPECT_EQ(zone.is_free(cell), nearest == 0);
        EXPECT_EQ(zone.is_slaved(cell), nearest > 0 && nearest <= 4);
        n_free += nearest == 0;
        n_slaved += nearest > 0 && nearest <= 4;
      });
  EXPECT_EQ(zone.n_free_cells(), n_free);
  EXPECT_EQ(zone.n_free_cells(), 8 + 1);
  EXPECT_EQ(zone.n_slaved_cells(), n_slaved);
}

TEST(Zone, GrowsOnceAndInsideThePlateOnly)
{
  Zone zone({6, 6, 6}, 2);
  EXPECT_TRUE(zone.would_grow({{{-5, -5, -5}, {1, 1, 1}}}));
  EXPECT_TRUE(zone.grow({{{-5, -5, -5}, {1, 1, 1}}}));
  EXPECT_EQ(zone.n_free_cells(), 1);
  EXPECT_FALSE(zone.would_grow({{{0, 0, 0}, {1, 1, 1}}}));
  EXPECT_FALSE(zone.grow({{{0, 0, 0}, {1, 1, 1}}}));
  EXPECT_FALSE(zone.grow({{{6, 0, 0}, {9, 6, 6}}})); // outside
  EXPECT_FALSE(zone.grow({}));
  EXPECT_TRUE(zone.grow({{{0, 0, 0}, {2, 1, 1}}}));
  EXPECT_EQ(zone.n_free_cells(), 2);
  EXPECT_EQ(zone.layer({2, 0, 0}), 1);
  EXPECT_EQ(zone.layer({3, 0, 0}), 2);
  EXPECT_EQ(zone.layer({4, 0, 0}), zone.far());
}

TEST(Zone, PointsHaveTheKindOfTheirCell)
{
  Zone zone({8, 3, 3}, 2);
  zone.grow({{{0, 0, 0}, {2, 3, 3}}});
  EXPECT_EQ(zone.kind(3, 0, 0), PointKind::free);
  EXPECT_EQ(zone.kind(4, 0, 0), PointKind::slaved);
  EXPECT_EQ(zone.kind(7, 5, 5), PointKind::slaved);
  EXPECT_EQ(zone.kind(8, 0, 0), PointKind::absent);
  zone.set_contact_region({{{5, 0, 0}, {6, 3, 3}}});
  EXPECT_EQ(zone.kind(8, 0, 0), PointKind::absent);
  EXPECT_EQ(zone.kind(10, 0, 0), PointKind::contact);
  EXPECT_EQ(zone.kind(11, 5, 3), PointKind::contact);
  EXPECT_EQ(zone.kind(10, 3, 3), PointKind::absent) << "not on the surface";
  EXPECT_EQ(zone.kind(12, 0, 0), PointKind::absent);
  EXPECT_TRUE(zone.has_contact({5, 0, 0}));
  zone.grow({{{0, 0, 0}, {4, 3, 3}}});
  EXPECT_EQ(zone.kind(10, 0, 0), PointKind::slaved) << "a layer goes before contact";
  EXPECT_FALSE(zone.has_contact({5, 0, 0}));
  zone.set_contact_region({});
  EXPECT_EQ(zone.kind(14, 0, 0), PointKind::absent);
}

TEST(Zone, GrowsNoFurtherThanItsLimit)
{
  Zone zone({12, 12, 3}, 2);
  EXPECT_EQ(zone.rows(), (std::array<int, 2>{0, 24}));
  zone.set_limit({{0, 4, 0}, {6, 7, 3}});
  zone.grow({{{0, 0, 0}, {2, 12, 3}}});
  EXPECT_FALSE(zone.is_free({0, 3, 0}));
  EXPECT_TRUE(zone.is_free({0, 4, 0}));
  EXPECT_TRUE(zone.is_free({0, 6, 2}));
  EXPECT_FALSE(zone.is_free({0, 7, 0}));
  EXPECT_FALSE(zone.would_grow({{{0, 0, 0}, {2, 12, 3}}}));
  // Pad and halo on either side, and contact points wherever they are.
  EXPECT_EQ(zone.rows(), (std::array<int, 2>{4, 18}));
  zone.set_contact_region({{{8, 1, 0}, {9, 2, 1}}});
  EXPECT_EQ(zone.rows(), (std::array<int, 2>{2, 18}));
}

TEST(Zone, LatticeOfALimitedZoneHasTheSamePointsAndBonds)
{
  const auto stencil = make_stencil(1e-3, 3., InfluenceFunction::cone);
  for (const bool mirrored : {false, true})
  {
    const Lattice::Box box{Vector3::Zero(), 1e-3, {16, 24, 8}, mirrored};
    std::vector<std::vector<std::array<int, 4>>> bonds(2);
    for (const bool limited : {false, true})
    {
      Zone zone({8, 12, 4}, stencil.reach);
      const Zone::Cells cells{{2, mirrored ? 0 : 4, 0}, {5, 6, 4}};
      if (limited)
        zone.set_limit(cells);
      zone.grow({cells});
      const Lattice lattice(box, stencil, 0, 1, {}, &zone);
      const auto intact = lattice.intact_bonds();
      for (std::ptrdiff_t p = 0; p < lattice.owned_end(); ++p)
        for (std::size_t k = 0; k < stencil.offsets.size(); ++k)
          if ((intact[p / 8 * stencil.offsets.size() + k] >> (p % 8)) & 1)
          {
            const auto c = lattice.coordinates(p);
            EXPECT_EQ(lattice.index(c[0], c[1], c[2]), p);
            bonds[limited].push_back({c[0], c[1], c[2], static_cast<int>(k)});
          }
      EXPECT_LT(limited ? lattice.row_stride() : 0, 24);
      std::sort(bonds[limited].begin(), bonds[limited].end());
    }
    EXPECT_GT(bonds[0].size(), 10000u);
    EXPECT_EQ(bonds[0], bonds[1]);
  }
}

TEST(Zone, WeightsOfThePadAreOneAndOfTheHaloZero)
{
  Zone zone({8, 1, 1}, 4);
  zone.grow({{{0, 0, 0}, {1, 1, 1}}});
  for (int x = 0; x < 16; ++x)
    EXPECT_EQ(zone.weight(x, 0, 0), x < 2 + 4 ? 1. : 0.) << x;
}

TEST(Zone, BlendFunctionsFallFromOneToZero)
{
  // Three layers are six points wide; their centres lie at (i + 1/2)/6.
  for (const auto function : {BlendFunction::linear, BlendFunction::cubic})
  {
    Zone zone({8, 1, 1}, 2, function, 3);
    zone.grow({{{0, 0, 0}, {1, 1, 1}}});
    for (int x = 0; x < 2; ++x)
      EXPECT_EQ(zone.weight(x, 0, 0), 1.);
    for (int x = 2; x < 8; ++x)
    {
      const double t = (x - 2 + 0.5) / 6.;
      const double expected =
          function == BlendFunction::linear ? 1. - t : 1. - 3. * t * t + 2. * t * t * t;
      EXPECT_NEAR(zone.weight(x, 1, 1), expected, 1e-15); // two ways to write the cubic
    }
    for (int x = 8; x < 16; ++x)
      EXPECT_EQ(zone.weight(x, 0, 0), 0.);
  }
}

TEST(Zone, BlendIsTheSameOnAllSidesOfTheZone)
{
  Zone zone({9, 9, 9}, 2, BlendFunction::linear, 2);
  zone.grow({{{4, 4, 4}, {5, 5, 5}}});
  for (int x = 0; x < 18; ++x)
    for (int y = 0; y < 18; ++y)
      for (int z = 0; z < 18; ++z)
      {
        EXPECT_EQ(zone.weight(x, y, z), zone.weight(17 - x, y, z));
        EXPECT_EQ(zone.weight(x, y, z), zone.weight(y, z, x));
        // Distance in points along the longest axis, corners included.
        const int outside     = std::max({8 - x, x - 9, 8 - y, y - 9, 8 - z, z - 9, 0});
        const double expected = outside == 0 ? 1. : std::max(0., 1. - (outside - 0.5) / 4.);
        EXPECT_DOUBLE_EQ(zone.weight(x, y, z), expected) << x << ' ' << y << ' ' << z;
      }
}

TEST(Zone, RimAreFreeCellsNearOthers)
{
  Zone zone({20, 9, 3}, 2);
  zone.grow({{{0, 0, 0}, {12, 9, 3}}});
  const auto interface_band = zone.interface_band(3);
  zone.for_each_cell(
      [&](const Zone::Cell &cell)
      { EXPECT_EQ(interface_band[zone.number(cell)] != 0, cell[0] >= 9 && cell[0] < 12); });
  zone.grow({{{0, 0, 0}, {20, 9, 3}}}); // everything: no interface, no interface_band
  for (const char near : zone.interface_band(3))
    EXPECT_EQ(near, 0);
}

TEST(Zone, CellsHoldAsManyPointsAsChosen)
{
  for (const int n : {1, 2, 4})
  {
    Zone zone({6, 6, 6}, 2, BlendFunction::linear, 4 / n, n);
    zone.grow({{{0, 0, 0}, {1, 6, 6}}});
    EXPECT_EQ(zone.points_per_edge(), n);
    for (int x = 0; x < 6 * n; ++x)
    {
      EXPECT_EQ(zone.cell_of(x, 0, n - 1), (Zone::Cell{x / n, 0, 0}));
      EXPECT_EQ(zone.kind(x, 1, 1) == PointKind::free, x < n);
      // Four points of blend, whatever the size of the cells.
      const int beyond = x - n + 1;
      EXPECT_DOUBLE_EQ(zone.weight(x, 1, 1), beyond < 1   ? 1.
                                             : beyond > 4 ? 0.
                                                          : 1. - (beyond - 0.5) / 4.);
    }
  }
}
} // namespace
} // namespace ricochet::tests
