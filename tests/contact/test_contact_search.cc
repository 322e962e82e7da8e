// SPDX-License-Identifier: LGPL-2.1-or-later
// No contact is ever missed: at every step of a violent run the forces and the number of contacts
// are those of the double loop over all points of all ranks and their images.
#include "contact/contact_numbering.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/exchange.h"
#include "ricochet/contact/contact_search.h"
#include "ricochet/contact/short_range_contact.h"
#include "support/body.h"

#include <gtest/gtest.h>

#include <cctype>

namespace ricochet::tests
{
namespace
{
using OwnBodies = std::vector<std::unique_ptr<PeridynamicBody>>;

constexpr double dx     = 1e-3;
constexpr double factor = 15.;

struct Collision
{
  std::string search;
  bool mirrored;
  int n_bodies;
};

void PrintTo(const Collision &collision, std::ostream *out)
{
  *out << collision.search;
}

class ContactSearches : public testing::TestWithParam<Collision>
{
};

std::vector<Collision> all_collisions()
{
  std::vector<Collision> collisions;
  for (const auto &name : contact_search_names())
    for (const bool mirrored : {false, true})
      for (const int n_bodies : {1, 2})
        collisions.push_back({name, mirrored, n_bodies});
  return collisions;
}

INSTANTIATE_TEST_SUITE_P(Collisions, ContactSearches, testing::ValuesIn(all_collisions()),
                         [](const auto &info)
                         {
                           const auto &collision = info.param;
                           return camel_case(collision.search) +
                                  (collision.n_bodies == 1 ? "OneBody" : "TwoBodies") +
                                  (collision.mirrored ? "Half" : "Full");
                         });

/// What the double loop needs to know of a point.
struct Point
{
  int body, lattice[3]; // y negative for an image
  double position[3];
  bool damaged, image;
  int rank, flat;
};

std::vector<Point> all_points(const OwnBodies &bodies, const bool mirrored)
{
  int rank, n_ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  std::vector<Point> own;
  for (const auto &body : bodies)
    for_each_point(*body,
                   [&](const std::ptrdiff_t p)
                   {
                     const auto c = body->lattice().coordinates(p);
                     const auto x = position(*body, p);
                     own.push_back({static_cast<int>(&body - bodies.data()),
                                    {c[0], c[1], c[2]},
                                    {x[0], x[1], x[2]},
                                    body->is_damaged(p),
                                    false,
                                    rank,
                                    static_cast<int>(p)});
                   });
  auto all = joined(exchange_lists(MPI_COMM_WORLD, std::vector<std::vector<Point>>(n_ranks, own)));
  for (std::size_t i = 0, n = all.size(); mirrored && i < n; ++i)
  {
    Point image      = all[i];
    image.lattice[1] = -1 - image.lattice[1];
    image.position[1] *= -1.;
    image.image = true;
    all.push_back(image);
  }
  return all;
}

struct Reference
{
  std::vector<std::vector<Vector3>> force; // per body and flat index
  double n_touching = 0.;                  // half of a pair for each point of this rank in it
};

/// The law of contact/short_range_contact.h on the points of this rank, from all others.
Reference reference_forces(const OwnBodies &bodies, const bool mirrored)
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  Reference result;
  for (const auto &body : bodies)
    result.force.emplace_back(body->lattice().size(), Vector3::Zero());
  const double k = factor * 18. * bodies[0]->material().bulk_modulus * std::pow(dx, 6) /
                   (M_PI * std::pow(bodies[0]->lattice().stencil().horizon, 5));
  const auto all = all_points(bodies, mirrored);
  for (const auto &a : all)
  {
    if (a.rank != rank || a.image)
      continue;
    const auto &body    = *bodies[a.body];
    const auto &offsets = body.lattice().stencil().offsets;
    for (const auto &b : all)
    {
      if (std::abs(b.position[0] - a.position[0]) >= 1.35 * dx) // most, quickly
        continue;
      const Vector3 d = Vector3(b.position[0], b.position[1], b.position[2]) -
                        Vector3(a.position[0], a.position[1], a.position[2]);
      const int step[] = {b.lattice[0] - a.lattice[0], b.lattice[1] - a.lattice[1],
                          b.lattice[2] - a.lattice[2]};
      if (d.norm() >= 1.35 * dx || (&a == &b))
        continue;
      double reference_distance;
      if (a.body == b.body)
      {
        reference_distance = dx * Vector3(step[0], step[1], step[2]).norm();
        bool touch         = a.damaged || b.damaged;
        for (std::size_t n = 0; n < offsets.size(); ++n)
          for (const int sign : {1, -1})
            if (step[0] == sign * offsets[n].x && step[1] == sign * offsets[n].y &&
                step[2] == sign * offsets[n].z)
            {
              const std::ptrdiff_t from =
                  sign == 1 ? a.flat : a.flat - body.lattice().shift(offsets[n]);
              touch = !is_intact(body, from, n);
            }
        if (!touch)
          continue;
      }
      else
      {
        const auto at = [&](const Point &point)
        {
          return bodies[point.body]->lattice().reference_position(
              {point.lattice[0], point.lattice[1], point.lattice[2]});
        };
        reference_distance = (at(b) - at(a)).norm();
      }
      const double overlap = std::min(0.9 * reference_distance, 1.35 * dx) - d.norm();
      if (overlap <= 0.)
        continue;
      result.n_touching += 0.5;
      result.force[a.body][a.flat] -= k * overlap * d.normalized();
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, &result.n_touching, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return result;
}

OwnBodies colliding_bodies(const Collision &collision)
{
  OwnBodies bodies;
  for (int number = 0; number < collision.n_bodies; ++number)
  {
    BodySample sample;
    sample.family.horizon_ratio = 2.5;
    sample.n                    = {18, 7, collision.n_bodies == 1 ? 8 : 4};
    sample.corner               = {0., 0., -4. * dx * number};
    sample.number               = number;
    sample.mirror_y             = collision.mirrored;
    sample.critical_stretch     = 0.01;
    sample.communicator         = MPI_COMM_WORLD;
    bodies.push_back(make_body(sample));
    // A jet into the middle, a few very fast points, and a part that stays at rest until it is hit.
    auto &body = *bodies.back();
    for_each_point(body,
                   [&](const std::ptrdiff_t p)
                   {
                     const auto c = body.lattice().coordinates(p);
                     Random random(c[0] + 100 * (c[1] + 100 * c[2]) + 1000003 * number);
                     Vector3 v = Vector3::Zero();
                     if (c[0] < 7)
                       v = Vector3(500., -300. + 40. * c[1], -100.) + 100. * random.vector();
                     if (c[0] % 6 == 2 && c[2] == 0)
                       v = 3000. * random.vector();
                     set(body.state().arrays.velocity, p, v);
                   });
  }
  return bodies;
}

/// Steps the bodies and compares every step with the double loop; returns the largest number of
/// contacts.
double expect_all_contacts(const OwnBodies &bodies, ShortRangeContact &debris, const bool mirrored,
                           const double dt, const int n_steps)
{
  double most_touching = 0.;
  for (int step = 0; step < n_steps; ++step)
  {
    std::vector<std::vector<Vector3>> before;
    for (const auto &body : bodies)
    {
      body->update_ghosts();
      body->break_bonds();
      body->compute_internal_forces({false});
      before.emplace_back(body->lattice().size(), Vector3::Zero());
      for_each_point(*body,
                     [&](const std::ptrdiff_t p)
                     {
                       before.back()[p] = force(*body, p);
                       set(body->state().arrays.force, p, Vector3::Zero());
                     });
    }
    debris.add_forces(dt);
    const auto reference = reference_forces(bodies, mirrored);
    EXPECT_EQ(debris.n_touching(), reference.n_touching) << "step " << step;
    most_touching      = std::max(most_touching, reference.n_touching);
    const double scale = debris.squared_frequency(*bodies[0]) * bodies[0]->point_mass() * dx;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      for_each_point(*bodies[i],
                     [&](const std::ptrdiff_t p)
                     {
                       const Vector3 f = force(*bodies[i], p);
                       EXPECT_LT((f - reference.force[i][p]).norm(), 1e-13 * scale);
                       set(bodies[i]->state().arrays.force, p, before[i][p] + f);
                     });
      bodies[i]->advance(dt, dt);
    }
  }
  return most_touching;
}

TEST_P(ContactSearches, NoContactIsEverMissed)
{
  const auto bodies = colliding_bodies(GetParam());
  ShortRangeContact debris(MPI_COMM_WORLD, pointers(bodies), factor, GetParam().mirrored,
                           GetParam().search);
  // A tenth of a spacing per step for the fastest.
  const int n_steps = 120;
  EXPECT_GT(expect_all_contacts(bodies, debris, GetParam().mirrored, 0.05e-6, n_steps), 100.);
  // Otherwise the test would be an easy one.
  long n_single = debris.n_single_searches();
  MPI_Allreduce(MPI_IN_PLACE, &n_single, 1, MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_GT(n_single, 10);
  EXPECT_GT(debris.n_searches(), 2);
  EXPECT_LT(debris.n_searches(), n_steps / 2);
}

TEST_P(ContactSearches, FragmentIsFeltBySoundMaterialFarFromAllDamage)
{
  // The end of a bar flies at the top of its other end: within the bar, or, having crossed the
  // symmetry plane, at the bar's image. With two bodies it is a body of its own.
  const auto &collision = GetParam();
  for (const double side : {1., -1.})
  {
    if (side < 0. && !collision.mirrored)
      continue;
    OwnBodies bodies;
    for (int number = 0; number < collision.n_bodies; ++number)
    {
      BodySample sample;
      sample.family.horizon_ratio = 1.5;
      sample.n                    = {number == 0 ? 60 : 9, 4, 4};
      sample.corner               = {0., 0., -20. * dx * number};
      sample.number               = number;
      sample.mirror_y             = collision.mirrored;
      sample.critical_stretch     = 0.01;
      sample.communicator         = MPI_COMM_WORLD;
      bodies.push_back(make_body(sample));
    }
    const auto &fragment = *bodies.back();
    for_each_point(fragment,
                   [&](const std::ptrdiff_t p)
                   {
                     const auto c = fragment.lattice().coordinates(p);
                     if (c[0] > 5) // more points than are searched one by one
                       return;
                     auto &a = bodies.back()->state().arrays;
                     set(a.position, p,
                         dx * Vector3(50.3 + c[0], side * (c[1] + 5.7) * 0.5, 7.2 + c[2]));
                     set(a.velocity, p, Vector3(100., 0., -1500.));
                   });
    ShortRangeContact debris(MPI_COMM_WORLD, pointers(bodies), factor, collision.mirrored,
                             collision.search);
    EXPECT_GT(expect_all_contacts(bodies, debris, collision.mirrored, 0.05e-6, 60), 3.);
  }
}

TEST(ContactSearch, NumbersTellNeighboursAndPlaces)
{
  Collision collision{"linked cells", true, 2};
  const auto bodies = colliding_bodies(collision);
  const ContactNumbering numbering(pointers(bodies));
  const auto &stencil = bodies[1]->lattice().stencil();
  const int reach     = stencil.reach + 1;
  const auto &n       = bodies[1]->lattice().box().n;
  int n_neighbours    = 0;
  for (int x = 0; x < 4; ++x)
    for (int y = -n[1]; y < n[1]; ++y)
      for (int z = 0; z < n[2]; ++z)
      {
        const std::array<int, 3> at{x, y, z};
        const auto id    = numbering.id(1, at);
        const auto place = numbering.place(id);
        EXPECT_EQ(place.body, 1);
        EXPECT_EQ(place.lattice, at);
        EXPECT_EQ(numbering.offset(numbering.id(0, {0, 0, 0}), id), -1) << "another body";
        for (int i = 0; i <= reach; ++i)
          for (int j = -n[1] - y; j < n[1] - y; ++j)
            for (int k = -z; k < n[2] - z; ++k)
            {
              const auto other = numbering.id(1, {x + i, y + j, z + k});
              if (other <= id)
                continue;
              const int offset = numbering.offset(id, other);
              const bool near  = i * i + j * j + k * k <= stencil.squared_range;
              EXPECT_EQ(offset >= 0, near);
              if (offset >= 0)
              {
                const auto &o = stencil.offsets[offset];
                EXPECT_EQ((std::array<int, 3>{o.x, o.y, o.z}), (std::array<int, 3>{i, j, k}));
                ++n_neighbours;
              }
            }
      }
  EXPECT_GT(n_neighbours, 1000);
}

TEST(ContactSearch, UnknownNameShowsTheMenu)
{
  Collision collision{"linked cells", false, 1};
  const auto bodies = colliding_bodies(collision);
  try
  {
    ShortRangeContact debris(MPI_COMM_WORLD, pointers(bodies), 1., false, "octree");
    FAIL() << "no error";
  }
  catch (const InputError &error)
  {
    const std::string message = error.what();
    for (const auto &name : contact_search_names())
      EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}
} // namespace
} // namespace ricochet::tests
