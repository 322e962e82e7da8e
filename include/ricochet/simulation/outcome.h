// SPDX-License-Identifier: LGPL-2.1-or-later
// Watches a projectile and tells when and how its impact has been decided: ricochet, perforate,
// edge, pushed or stuck. Plates are judged as they are then, not as they were: a free plate that is
// hit moves away.
#pragma once

#include "ricochet/base/state_archive.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ricochet
{
enum class Outcome
{
  ricochet,  // left through the face it came from, upwards
  perforate, // left through the rear face of the last plate
  edge,      // left through an edge: it neither came back nor went through
  pushed,    // in front of the target, which flies off faster than it can follow
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
  std::string reason; // why the run ended, for the user: a clause that can begin a sentence
};

/// A plate as it is: its undeformed box, moved as the sound part of it has moved.
struct PlatePlace
{
  Vector3 low;                        // corner, mirrored half included [m]
  Vector3 high;                       // likewise [m]
  Vector3 velocity = Vector3::Zero(); // of the sound part [m/s]
};

/// What the watch is shown of a step.
struct Observation
{
  double time;                              // [s]
  Vector3 position;                         // of the projectile's centre [m]
  Vector3 velocity;                         // likewise [m/s]
  std::pair<Vector3, Vector3> bounding_box; // lowest and highest corner of the projectile [m]
  bool touching;                            // something, debris included
  /// From top to bottom. Asked for only where it matters: it costs a pass over all points.
  std::function<std::vector<PlatePlace>()> plates;
};

/// Watches an impact, step by step.
class OutcomeWatch
{
public:
  /// `plates` undeformed, from top to bottom; `impact_speed` in m/s. `free_time`: without a touch
  /// this long [s] the projectile counts as free.
  OutcomeWatch(std::vector<PlatePlace> plates, double impact_speed, double free_time);

  /// Call once per step, after the forces.
  void update(const Observation &now);

  /// Saves or restores what has been seen.
  void exchange_state(StateArchive &archive);

  /// The projectile is clear of the target, moves away from it and has touched nothing, debris
  /// included, for the free time; or it rests.
  bool decided() const { return decided_; }

  /// The verdict so far; if the run ended for another reason than decided(), that reason is given
  /// by the caller.
  OutcomeVerdict verdict(const std::string &other_reason) const;

  /// Of the projectile's lowest point below the undeformed front face while it touched something
  /// [m]. Of a perforation it says nothing.
  double max_depth() const { return max_depth_; }
  double path() const { return path_; } // length of the centre's path [m]
  /// From the first to the last touch of projectile and plates, debris included [s].
  double contact_duration() const { return last_contact_ - first_contact_; }

private:
  /// The face behind which the whole projectile (or, if `centre`, its centre) lies and from which
  /// it moves away.
  ExitFace face_left_behind(bool centre) const;
  ExitFace face_over_an_edge() const;
  /// It rests when it has been slower than a hundredth of the impact, against one of the plates,
  /// for half as long as all its motion in the target took, and for the free time.
  void look_for_rest();
  std::vector<PlatePlace> plates() const;     // as they are now
  int plate_left_behind(ExitFace face) const; // from 1; 0 for none
  /// "the rear face of plate 2", for the user.
  std::string way_out(ExitFace face) const;

  std::vector<PlatePlace> undeformed_;
  double impact_speed_, free_time_;
  Observation now_{};
  bool decided_ = false, has_touched_ = false, rests_ = false;
  /// That decided it: the plates move on until somebody asks for the verdict.
  ExitFace face_    = ExitFace::none;
  double max_depth_ = 0., path_ = 0.;
  double first_contact_ = 0., last_contact_ = 0., last_motion_ = 0.; // times [s]
  double height_  = 0.; // of the centre when it was last between the edges [m]
  long n_updates_ = 0;
};
} // namespace ricochet
