// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

namespace ricochet::tests
{
namespace
{
struct Torn
{
  double sound, intact, booked;
  std::map<std::array<int, 3>, double> damage; // of this rank's points
};

/// Everything beyond a plane across the ranks' shares is pulled away.
Torn torn(const MPI_Comm communicator, const bool mirrored)
{
  BodySample sample;
  sample.n                = {12, 5, 4};
  sample.critical_stretch = 0.1;
  sample.mirror_y         = mirrored;
  sample.communicator     = communicator;
  const auto body         = make_body(sample);
  deform(
      *body,
      [&](const Vector3 &X) -> Vector3
      { return X + Vector3(X.x() > 6e-3 ? 0.4e-3 : 0., 0., 0.3 * std::max(0., X.x() - 3e-3)); },
      /*breaking=*/true);
  body->book_fracture(1e-7);
  Torn result{body->count_sound_bonds(), body->count_bonds(), body->n_broken_bonds(), {}};
  for_each_point(*body, [&](const std::ptrdiff_t p)
                 { result.damage[body->lattice().coordinates(p)] = body->damage(p); });
  return result;
}

TEST(BondDamageOnRanks, CountsAndDamageAreThoseOfOneRank)
{
  for (const bool mirrored : {false, true})
  {
    const auto shared = torn(MPI_COMM_WORLD, mirrored), alone = torn(MPI_COMM_SELF, mirrored);
    EXPECT_EQ(shared.sound, alone.sound);
    EXPECT_EQ(shared.intact, alone.intact);
    EXPECT_EQ(shared.booked, alone.booked);
    EXPECT_EQ(alone.booked, alone.sound - alone.intact) << "what is booked is what is gone";
    EXPECT_GT(alone.booked, 100.);
    EXPECT_GT(alone.intact, 100.);
    for (const auto &[place, damage] : shared.damage)
      EXPECT_EQ(damage, alone.damage.at(place));
  }
}
} // namespace
} // namespace ricochet::tests
