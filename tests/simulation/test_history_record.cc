// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/history_record.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace ricochet::tests
{
namespace
{
TEST(HistoryRecord, ColumnsHaveNamesThatTellThemApartUnitsAndMeanings)
{
  std::set<std::string> names;
  for (const auto &column : history_columns())
  {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_EQ(column.name.find_first_of(",/[\""), std::string::npos) << column.name;
    EXPECT_FALSE(column.unit.empty()) << column.name;
    EXPECT_FALSE(column.meaning.empty()) << column.name;
  }
}

TEST(HistoryRecord, EveryValueIsThatOfItsName)
{
  Simulation simulation(MPI_COMM_WORLD, two_plates());
  for (int i = 0; i < 60; ++i)
  {
    simulation.compute_forces(false);
    simulation.advance();
  }
  simulation.compute_forces(true);
  const Totals totals = totals_of(simulation);
  const auto record   = history_record({simulation, totals});
  ASSERT_EQ(record.size(), history_columns().size());
  std::map<std::string, double> value;
  for (std::size_t i = 0; i < record.size(); ++i)
    value[history_columns()[i].name] = record[i];

  const auto motion = simulation.present_motion();
  EXPECT_NE(motion.velocity, simulation.projectile().motion().velocity) << "of half a step before";
  EXPECT_EQ(value.at("time"), simulation.time() / 1e-6);
  EXPECT_EQ(value.at("z"), motion.position.z() / 1e-3);
  EXPECT_EQ(value.at("velocity x"), motion.velocity.x());
  EXPECT_EQ(value.at("spin y"), motion.spin.y());
  EXPECT_NEAR(std::hypot(value.at("velocity x"), value.at("velocity y"), value.at("velocity z")),
              value.at("speed"), 1e-9 * value.at("speed"));
  EXPECT_GT(value.at("force normal"), 0.);
  EXPECT_EQ(value.at("energy projectile"), totals.energies.projectile);
  EXPECT_EQ(value.at("broken bonds"), totals.broken_bonds);
  EXPECT_EQ(value.at("residual relative"), totals.energies.residual() / totals.energies.initial);

  // All columns in joules are the balance: what is missing in it would be missing here.
  double sum = 0.;
  for (const auto &column : history_columns())
    if (column.unit == "J")
      sum += value.at(column.name);
  EXPECT_NEAR(sum, totals.energies.initial, 1e-12 * totals.energies.initial);
}

TEST(Totals, OfAModelWithoutEnergyAreNoShares)
{
  const Totals none;
  EXPECT_EQ(none.share(3.), 0.);
  EXPECT_EQ(none.relative_residual(), 0.);
}
} // namespace
} // namespace ricochet::tests
