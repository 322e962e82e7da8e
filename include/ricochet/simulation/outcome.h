// SPDX-License-Identifier: LGPL-2.1-or-later
// Watches a simulation and tells when and how it has been decided: ricochet, perforate, edge or
// stuck.
#pragma once

#include "ricochet/simulation/simulation.h"

#include <string>

namespace ricochet
{
enum class Outcome
{
  ricochet,  // left through the face it came from
  perforate, // left through the rear face of the last plate
  edge,      // left through an edge: it neither came back nor went through
  stuck,     // at rest in the target
  undecided
};

/// As in summary.json.
const char *name_of(Outcome outcome);

/// Where a projectile has left the target.
enum class ExitFace
{
  none, // it has not
  front,
  rear,
  edge
};

/// As in summary.json.
const char *name_of(ExitFace face);

/// How a run has ended.
struct OutcomeVerdict
{
  Outcome outcome;    // what became of the projectile
  ExitFace exit_face; // where it has left
  int exit_plate;     // whose face or edge that is, from 1; 0 if it has not left
  std::string reason; // why the run ended, for the user
};

/// Watches a simulation, step by step.
class OutcomeWatch
{
public:
  /// At the start; the simulation must outlive this object.
  explicit OutcomeWatch(const Simulation &simulation);

  /// Call once per step, after Simulation::compute_forces().
  void update();

  /// The projectile is clear of the undeformed target, moves away from it and has touched nothing,
  /// debris included, for the scene's free time; or it rests.
  bool decided() const { return decided_; }

  /// The verdict so far; if the run ended for another reason than decided(), that reason is given
  /// by the caller.
  OutcomeVerdict verdict(const std::string &other_reason) const;

  double max_depth() const
  {
    return max_depth_;
  } // of the lowest point of the projectile below the front face [m]
  double path() const { return path_; } // length of the centroid's path [m]
  /// From the first to the last touch of projectile and plates, debris included [s].
  double contact_duration() const { return last_contact_ - first_contact_; }

private:
  /// The face behind which the whole projectile (or, if `centroid`, its centre) lies and from which
  /// it moves away. Over an edge, but above the front or below the rear face when its centre passed
  /// it, counts as that face.
  ExitFace face_left_behind(bool centroid) const;
  int plate_left_behind(ExitFace face) const; // from 1; 0 for none
  /// "the rear face of plate 2", for the user.
  std::string way_out(ExitFace face) const;

  const Simulation &simulation_;
  bool decided_     = false;
  double max_depth_ = 0., path_ = 0.;
  double first_contact_ = 0., last_contact_ = 0., last_motion_ = 0.; // times [s]
  bool has_touched_ = false;
  double height_;         // of the centre when it was last between the edges [m]
  Vector3 last_position_; // of the centre
};
} // namespace ricochet
