// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/frame_fields.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace ricochet::tests
{
namespace
{
StressState state_of(const double first)
{
  StressState state;
  state.stress(0, 0)   = 3. * first; // simple tension: a third of it as negative pressure
  state.dilatation     = first + 1.;
  state.energy_density = first + 2.;
  return state;
}

TEST(FrameFields, HaveNamesThatTellThemApartUnitsAndMeanings)
{
  std::set<std::string> names;
  for (const auto &field : frame_fields())
  {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_FALSE(field.unit.empty()) << field.name;
    EXPECT_FALSE(field.meaning.empty()) << field.name;
    EXPECT_TRUE(field.n_components == 1 || field.n_components == 3) << field.name;
    EXPECT_EQ(field.title(), field.unit == "-" ? field.name : field.name + " [" + field.unit + "]");
  }
}

TEST(FrameFields, EveryValueIsThatOfItsName)
{
  PointFrame points;
  ElementFrame elements;
  for (const double i : {10., 20.}) // the second is asked for
  {
    points.displacement.emplace_back(i, i + 1., i + 2.);
    points.velocity.emplace_back(i + 3., i + 4., i + 5.);
    points.damage.push_back(i / 100.);
    points.state.add(state_of(i));
    points.body.push_back(static_cast<int>(i));
    elements.displacement.emplace_back(-i, -i - 1., -i - 2.);
    elements.velocity.emplace_back(-i - 3., -i - 4., -i - 5.);
    elements.state.add(state_of(-i));
    elements.body.push_back(static_cast<int>(i) + 1);
  }
  using Values = std::vector<double>;
  const std::map<std::string, std::pair<Values, Values>> expected{
      {"displacement", {{20., 21., 22.}, {-20., -21., -22.}}},
      {"velocity", {{23., 24., 25.}, {-23., -24., -25.}}},
      {"damage", {{0.2}, {0.}}},
      {"dilatation", {{21.}, {-19.}}},
      {"pressure", {{-20.}, {20.}}},
      {"von Mises stress", {{60.}, {60.}}},
      {"strain energy density", {{22.}, {-18.}}},
      {"body", {{20.}, {21.}}}};
  ASSERT_EQ(frame_fields().size(), expected.size());
  for (const auto &field : frame_fields())
  {
    const auto &[of_point, of_element] = expected.at(field.name);
    ASSERT_EQ(field.n_components, of_point.size()) << field.name;
    for (unsigned int d = 0; d < field.n_components; ++d)
    {
      // The norm of the deviator rounds.
      EXPECT_NEAR(field.of_point(points, 1, d), of_point[d], 1e-13) << field.name;
      EXPECT_NEAR(field.of_element(elements, 1, d), of_element[d], 1e-13) << field.name;
    }
  }
}
} // namespace
} // namespace ricochet::tests
