// SPDX-License-Identifier: LGPL-2.1-or-later
// One impact: plates, projectiles and contact between them, built from a scene, and the time step.
// How a step goes stands in dynamics/leapfrog.h. Knows neither files nor the clock on the wall.
#pragma once

#include "ricochet/contact/plate_joint.h"
#include "ricochet/contact/short_range_contact.h"
#include "ricochet/coupling/adaptive_plate.h"
#include "ricochet/coupling/clamped_edges.h"
#include "ricochet/dynamics/largest_frequency.h"
#include "ricochet/dynamics/leapfrog.h"
#include "ricochet/projectiles/projectile_contact.h"
#include "ricochet/simulation/energy_balance.h"

namespace ricochet
{
/// A plate as it is computed.
struct Plate
{
  std::unique_ptr<Body> body; // what the time integrator moves
  PeridynamicBody *points;    // all of the body or its peridynamic part
  AdaptivePlate *coupled;     // the body if elements carry a part of it, else null
  std::string zone_reason;    // why the zone is as it is, for the user
};

class Simulation
{
public:
  /// Builds everything. Collective. Throws InputError, for instance if the projectile starts inside
  /// a plate.
  Simulation(MPI_Comm communicator, const Scene &scene);

  /// Forces at the present time; with `energy` stored energies too, so that energies() may be
  /// called. Collective.
  void compute_forces(bool energy);
  /// To the next time; call after compute_forces(). Collective.
  void advance();

  /// Saves or restores all that moves, between steps: after advance(). A simulation to be restored
  /// has been built from the same scene, on any number of ranks, and has made no step. Collective.
  void exchange_state(StateArchive &archive);

  double time() const { return time_; } // [s]
  double dt() const { return dt_; }     // [s]
  long step() const { return step_; }   // made so far

  MPI_Comm communicator() const { return communicator_; } // of all its collective calls
  const Scene &scene() const { return scene_; }           // as given
  // Projectiles are counted from 0, the first; they do not touch each other.
  std::size_t n_projectiles() const { return projectiles_.size(); } // of the scene
  /// As it is now.
  const Projectile &projectile(const std::size_t i = 0) const { return *projectiles_[i]; }
  /// Of a projectile, with the velocities of the present time; after compute_forces().
  Projectile::Motion present_motion(const std::size_t i = 0) const
  {
    return projectiles_[i]->present_motion(dt_);
  }
  /// Of all plates on a projectile, at the last compute_forces().
  const ContactRecord &reaction(const std::size_t i = 0) const
  {
    return projectile_contacts_[i]->record();
  }

  std::size_t n_plates() const { return plates_.size(); }              // of the scene
  const Plate &plate(const std::size_t i) const { return plates_[i]; } // from 0, the uppermost
  /// The peridynamic points of each plate, from top to bottom.
  std::vector<const PeridynamicBody *> plates() const;
  std::vector<PeridynamicBody *> plates(); // likewise
  /// Null if the plate is peridynamic throughout.
  const AdaptivePlate *coupled_plate(const std::size_t i) const { return plates_[i].coupled; }
  AdaptivePlate *coupled_plate(const std::size_t i) { return plates_[i].coupled; } // likewise

  const MaterialParameters &material(std::size_t plate) const; // of a plate
  double critical_stretch(std::size_t plate) const;            // [-]

  /// Lower and upper corner of all plates in the reference configuration, mirrored half included
  /// [m].
  std::pair<Vector3, Vector3> target_box() const;

  /// Collective; after compute_forces(true), before advance().
  EnergyBalance energies() const;
  /// Force of all supports on the plates, after compute_forces() [N]. Collective.
  Vector3 support_reaction() const;
  /// Of the half step before the present time, with what supports have taken up. Collective.
  MomentumBalance momenta() const;
  // All numbers are those of whole bodies, also if a symmetry plane spares one half.
  double broken_bonds() const; // so far, each once; collective
  /// Of a plate to the one above; null: they only touch.
  const PlateJoint *joint_above(std::size_t plate) const { return joints_[plate].get(); }
  /// Box around the damaged points of a plate in the reference configuration [m]; low > high if
  /// there are none. Collective.
  std::pair<Vector3, Vector3> damaged_box(std::size_t plate) const;
  double n_points() const; // that have bonds or had, those for contact alone left out; collective
  double n_bonds() const;  // intact now; collective
  /// Of points and bonds that are computed: half with a symmetry plane [-].
  double computed_share() const { return scene_.symmetric ? 0.5 : 1.; }

  /// Throws RunError naming point, field and time if a field of this or another rank is not finite.
  /// Collective.
  void check_finite() const;
  /// "Point (x, y, z) of plate n is the fastest, at v m/s." Collective.
  std::string describe_fastest_point() const;

  // For pictures; between compute_forces() and advance(). Looking changes nothing.
  PointFrame points(FrameExtent extent) const;     // owned by this rank; collective
  SurfaceFrame surface() const;                    // of all projectiles
  ElementFrame elements(FrameExtent extent) const; // owned by this rank

  /// What limits the step, for the user.
  struct TimeStepInfo
  {
    double frequency;        // largest of the bonds [rad/s]
    double contact_share;    // of the squared frequency that contact adds [-]
    double seconds_per_step; // measured, forces only [s]
    double plates_dt;        // the step that the plates alone would allow [s]
    double projectile_dt;    // the least that a projectile allows; infinite if all are rigid [s]
  };
  TimeStepInfo time_step_info() const { return time_step_info_; } // of the step in use
  /// Of each plate alone, without contact.
  const std::vector<FrequencyEstimate> &frequencies() const { return frequencies_; }

private:
  void build_projectiles();
  void refuse_overlap(std::size_t projectile);
  void build_contact();
  void build_joints();
  void build_supports();
  double contact_stiffness(const PeridynamicBody &plate) const; // [N/m]
  /// Bound from above, without contact. Collective.
  FrequencyEstimate frequency_of(const Plate &plate) const;
  void choose_time_step();
  /// Of all plates, whose elastic force evaluations take so long [s].
  void start_relaxation(const std::vector<double> &elastic_seconds);

  MPI_Comm communicator_;
  Scene scene_;
  std::vector<Plate> plates_;
  std::unique_ptr<FrictionLaw> friction_law_;
  std::vector<std::unique_ptr<Projectile>> projectiles_;
  std::vector<std::unique_ptr<ProjectileContact>> projectile_contacts_; // of each
  std::unique_ptr<ShortRangeContact> short_range_contact_;
  /// Of each plate to the one above; null: none.
  std::vector<std::unique_ptr<PlateJoint>> joints_;
  std::vector<std::unique_ptr<ClampedEdges>> supports_; // of the plates that have some
  std::unique_ptr<Leapfrog> integrator_;
  TimeStepInfo time_step_info_;
  std::vector<FrequencyEstimate> frequencies_;
  double time_ = 0., dt_ = 0.;
  long step_             = 0;
  double initial_energy_ = 0.;
};
} // namespace ricochet
