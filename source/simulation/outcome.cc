// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/outcome.h"

#include "ricochet/base/number_text.h"

#include <algorithm>

namespace ricochet
{
namespace
{
// Slower than this share of the impact speed counts as rest: 0.01 % of the energy is left.
constexpr double rest_speed = 0.01;
} // namespace

const char *name_of(const Outcome outcome)
{
  switch (outcome)
  {
    case Outcome::ricochet:
      return "ricochet";
    case Outcome::perforate:
      return "perforate";
    case Outcome::edge:
      return "edge";
    case Outcome::stuck:
      return "stuck";
    case Outcome::undecided:
      break;
  }
  return "undecided";
}

const char *name_of(const ExitFace face)
{
  switch (face)
  {
    case ExitFace::front:
      return "front";
    case ExitFace::rear:
      return "rear";
    case ExitFace::edge:
      return "edge";
    case ExitFace::none:
      break;
  }
  return "none";
}

OutcomeWatch::OutcomeWatch(const Simulation &simulation) :
  simulation_(simulation), height_(simulation.projectile().motion().position.z()),
  last_position_(simulation.projectile().motion().position)
{
}

ExitFace OutcomeWatch::face_left_behind(const bool centroid) const
{
  const auto &motion     = simulation_.projectile().motion();
  const auto [low, high] = simulation_.target_box();
  const auto box         = centroid ? std::make_pair(motion.position, motion.position)
                                    : simulation_.projectile().bounding_box();
  const Vector3 &v       = motion.velocity;
  if (box.first.z() > high.z() && v.z() > 0.)
    return ExitFace::front;
  if (box.second.z() < low.z() && v.z() < 0.)
    return ExitFace::rear;
  for (const int axis : {0, 1})
    if ((box.first[axis] > high[axis] && v[axis] > 0.) ||
        (box.second[axis] < low[axis] && v[axis] < 0.))
      return height_ > high.z()  ? ExitFace::front
             : height_ < low.z() ? ExitFace::rear
                                 : ExitFace::edge;
  return ExitFace::none;
}

int OutcomeWatch::plate_left_behind(const ExitFace face) const
{
  const auto &plates = simulation_.plates();
  if (face == ExitFace::none)
    return 0;
  if (face == ExitFace::front)
    return 1;
  // From below: the first plate whose upper face lies above the projectile. In a gap it is the
  // lower plate's.
  for (std::size_t i = plates.size(); i > 1 && face == ExitFace::edge; --i)
    if (const auto &box = plates[i - 1]->lattice().box();
        height_ < box.corner.z() + box.n[2] * box.spacing)
      return static_cast<int>(i);
  return face == ExitFace::edge ? 1 : static_cast<int>(plates.size());
}

void OutcomeWatch::update()
{
  const auto &projectile = simulation_.projectile();
  const auto &motion     = projectile.motion();
  path_ += (motion.position - last_position_).norm();
  last_position_         = motion.position;
  const auto [low, high] = simulation_.target_box();
  if (motion.position.x() > low.x() && motion.position.x() < high.x() &&
      motion.position.y() > low.y() && motion.position.y() < high.y())
    height_ = motion.position.z();
  max_depth_ = std::max(max_depth_, high.z() - projectile.bounding_box().first.z());

  if (simulation_.reaction().n_touching > 0.)
  {
    last_contact_ = simulation_.time();
    if (!has_touched_)
      first_contact_ = last_contact_;
    has_touched_ = true;
  }
  if (motion.velocity.norm() > rest_speed * simulation_.scene().impact.speed)
    last_motion_ = simulation_.time();

  const double free_time = simulation_.scene().time.free_time;
  const bool free =
      simulation_.time() - last_contact_ >= free_time && face_left_behind(false) != ExitFace::none;
  const bool at_rest = simulation_.time() - last_motion_ >= free_time;
  decided_           = free || at_rest;
}

std::string OutcomeWatch::way_out(const ExitFace face) const
{
  std::string way = "the edge";
  if (face != ExitFace::edge)
    way = "the " + std::string(name_of(face)) + " face";
  if (simulation_.plates().size() > 1)
    way += " of plate " + std::to_string(plate_left_behind(face));
  return way;
}

OutcomeVerdict OutcomeWatch::verdict(const std::string &other_reason) const
{
  // A run that is cut short is judged by the centroid: a projectile that is on its way out has been
  // decided too.
  const ExitFace face = face_left_behind(!decided_);
  if (face == ExitFace::none && decided_)
    return {Outcome::stuck, face, 0,
            "the projectile is at rest (below " + with_digits(100. * rest_speed, 6) +
                " % of the impact speed)"};
  if (face == ExitFace::none)
    return {Outcome::undecided, face, 0, other_reason};
  if (!has_touched_)
    return {Outcome::undecided, ExitFace::none, 0, "the projectile has missed the target"};
  const Outcome outcome       = face == ExitFace::front  ? Outcome::ricochet
                                : face == ExitFace::rear ? Outcome::perforate
                                                         : Outcome::edge;
  const std::string free_time = with_digits(1e6 * simulation_.scene().time.free_time, 6);
  return {outcome, face, plate_left_behind(face),
          decided_ ? "the projectile has left through " + way_out(face) +
                         " and touched nothing for " + free_time + " us"
                   : other_reason + ", with the projectile's centre outside and on its way out"};
}
} // namespace ricochet
