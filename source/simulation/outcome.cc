// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/outcome.h"

#include "ricochet/base/number_text.h"

#include <algorithm>

namespace ricochet
{
namespace
{
// Slower than this share of the impact speed counts as rest: 0.01 % of the energy is left.
constexpr double rest_speed   = 0.01;
// At a turning point a projectile is slow, too, but for a hundredth of the time that it took to get
// there.
constexpr double rest_share   = 0.5;
// Between two looks at whether it rests, which cost a pass over the points each.
constexpr long steps_per_look = 20;
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
    case Outcome::pushed:
      return "pushed";
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

OutcomeWatch::OutcomeWatch(std::vector<PlatePlace> plates, const double impact_speed,
                           const double free_time) :
  undeformed_(std::move(plates)),
  impact_speed_(impact_speed), free_time_(free_time)
{
}

std::vector<PlatePlace> OutcomeWatch::plates() const
{
  return has_touched_ ? now_.plates() : undeformed_;
}

ExitFace OutcomeWatch::face_left_behind(const bool centre) const
{
  const Vector3 low       = centre ? now_.position : now_.bounding_box.first;
  const Vector3 high      = centre ? now_.position : now_.bounding_box.second;
  const auto all          = plates();
  const PlatePlace &first = all.front(), &last = all.back();
  if (low.z() > first.high.z() && now_.velocity.z() > first.velocity.z())
    return ExitFace::front;
  if (high.z() < last.low.z() && now_.velocity.z() < last.velocity.z())
    return ExitFace::rear;
  for (const int axis : {0, 1})
  {
    const auto beyond = [&](const PlatePlace &plate)
    {
      const double away = now_.velocity[axis] - plate.velocity[axis];
      return (low[axis] > plate.high[axis] && away > 0.) ||
             (high[axis] < plate.low[axis] && away < 0.);
    };
    if (std::all_of(all.begin(), all.end(), beyond))
      return face_over_an_edge();
  }
  return ExitFace::none;
}

/// Over an edge, but above the front face and rising, or below the rear one, counts as that face.
ExitFace OutcomeWatch::face_over_an_edge() const
{
  const auto all = plates();
  if (height_ > all.front().high.z() && now_.velocity.z() > 0.)
    return ExitFace::front;
  return height_ < all.back().low.z() ? ExitFace::rear : ExitFace::edge;
}

int OutcomeWatch::plate_left_behind(const ExitFace face) const
{
  const auto all = plates();
  if (face == ExitFace::none)
    return 0;
  if (face == ExitFace::front)
    return 1;
  // From below: the first plate whose upper face lies above the projectile. In a gap it is the
  // lower plate's.
  for (std::size_t i = all.size(); i > 1 && face == ExitFace::edge; --i)
    if (height_ < all[i - 1].high.z())
      return static_cast<int>(i);
  return face == ExitFace::edge ? 1 : static_cast<int>(all.size());
}

void OutcomeWatch::update(const Observation &now)
{
  if (n_updates_ > 0)
    path_ += (now.position - now_.position).norm();
  else
    height_ = now.position.z();
  now_ = now;
  ++n_updates_;
  const Vector3 &low = undeformed_.front().low, &high = undeformed_.front().high;
  if (now.position.x() > low.x() && now.position.x() < high.x() && now.position.y() > low.y() &&
      now.position.y() < high.y())
    height_ = now.position.z();

  if (now.touching)
  {
    last_contact_ = now.time;
    max_depth_    = std::max(max_depth_, high.z() - now.bounding_box.first.z());
    if (!has_touched_)
      first_contact_ = last_motion_ = now.time;
    has_touched_ = true;
  }
  if (has_touched_ && n_updates_ % steps_per_look == 0)
    look_for_rest();
  const bool free = now.time - last_contact_ >= free_time_;
  face_           = free || rests_ ? face_left_behind(false) : ExitFace::none;
  decided_        = (free && face_ != ExitFace::none) || rests_;
}

void OutcomeWatch::look_for_rest()
{
  const auto all = plates();
  const bool is_slow =
      std::any_of(all.begin(), all.end(),
                  [&](const PlatePlace &plate)
                  { return (now_.velocity - plate.velocity).norm() < rest_speed * impact_speed_; });
  if (!is_slow)
    last_motion_ = now_.time;
  rests_ = is_slow && now_.time - last_motion_ >=
                          std::max(free_time_, rest_share * (last_motion_ - first_contact_));
}

std::string OutcomeWatch::way_out(const ExitFace face) const
{
  std::string way = "the edge";
  if (face != ExitFace::edge)
    way = "the " + std::string(name_of(face)) + " face";
  if (undeformed_.size() > 1)
    way += " of plate " + std::to_string(plate_left_behind(face));
  return way;
}

OutcomeVerdict OutcomeWatch::verdict(const std::string &other_reason) const
{
  // A run that is cut short is judged by the centre: a projectile that is on its way out has been
  // decided too.
  const ExitFace face = decided_ ? face_ : face_left_behind(true);
  if (face == ExitFace::none && decided_)
    return {Outcome::stuck, face, 0,
            "the projectile is at rest in the target (below " + with_digits(100. * rest_speed, 6) +
                " % of the impact speed)"};
  if (face == ExitFace::none)
    return {Outcome::undecided, face, 0, other_reason};
  if (!has_touched_)
    return {Outcome::undecided, ExitFace::none, 0, "the projectile has missed the target"};

  const std::string free = " and touched nothing for " + with_digits(1e6 * free_time_, 6) + " us";
  const std::string when =
      decided_ ? "" : other_reason + ", with the projectile's centre outside and on its way out";
  if (face == ExitFace::front && now_.velocity.z() <= 0.)
    return {Outcome::pushed, ExitFace::none, 0,
            decided_
                ? "the target has been pushed away: it flies off ahead of the projectile, which "
                  "has stayed in front of it" +
                      free
                : when};
  const Outcome outcome = face == ExitFace::front  ? Outcome::ricochet
                          : face == ExitFace::rear ? Outcome::perforate
                                                   : Outcome::edge;
  return {outcome, face, plate_left_behind(face),
          decided_ ? "the projectile has left through " + way_out(face) + free : when};
}

void OutcomeWatch::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "outcome");
  archive.common("last position", now_.position);
  archive.common("has touched", has_touched_);
  archive.common("greatest depth", max_depth_);
  archive.common("path", path_);
  archive.common("first contact", first_contact_);
  archive.common("last contact", last_contact_);
  archive.common("last motion", last_motion_);
  archive.common("height", height_);
  archive.common("updates", n_updates_);
}
} // namespace ricochet
