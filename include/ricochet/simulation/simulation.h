// SPDX-License-Identifier: LGPL-2.1-or-later
// One impact: plates, projectile and all forces between them, and the time step. Knows neither
// files nor the clock on the wall; commands/run.h does. One step reads
//   ghosts <- positions;  bonds broken;  f = bonds + projectile contact + debris contact;  v += f
//   dt/m;  x += v dt
#pragma once

#include "ricochet/contact/short_range_contact.h"
#include "ricochet/coupling/adaptive_zone.h"
#include "ricochet/dynamics/power_iteration.h"
#include "ricochet/peridynamics/fracture_energy.h"
#include "ricochet/projectiles/projectile.h"
#include "ricochet/simulation/plate_zone.h"

namespace ricochet
{
/// All energies are those of the full model, also with a symmetry plane [J].
struct EnergyBalance
{
  double projectile; // kinetic
  double elastic;    // in a deformable projectile
  double kinetic;    // of the plates
  double strain;     // in intact bonds and elements
  double hourglass;  // in the hourglass modes of one-point elements
  double conversion; // lost where elements became points
  double contact;    // in the penalty springs between projectile and plates
  double debris;     // in the repulsion of debris
  double friction;   // turned into heat between projectile and plates
  double fracture;   // released by broken bonds
  double initial;    // kinetic energy of the projectile at the start
  double viscous;    // turned into heat by relaxation
  double absorbed;   // by edges that do not reflect
  /// Turned into heat between plates and in debris.
  double debris_friction;

  double residual() const
  {
    return initial - projectile - elastic - kinetic - strain - hourglass - conversion - contact -
           debris - friction - debris_friction - fracture - viscous - absorbed;
  }
};

/// Total momenta of the full model; with a symmetry plane only the components that it leaves free
/// are non-zero.
struct MomentumBalance
{
  Vector3 linear;  // [kg m/s]
  Vector3 angular; // about the origin [kg m^2/s]
};

class Simulation
{
public:
  /// Builds everything. Collective. Throws InputError, for instance if the projectile starts inside
  /// a plate.
  Simulation(MPI_Comm communicator, const Scene &scene);

  /// Forces at the present time; with `energy` strain energies too, so that energies() may be
  /// called.
  void evaluate(bool energy);
  /// To the next time: kick and drift. Call after evaluate().
  void advance();

  double time() const { return time_; } // [s]
  double dt() const { return dt_; }     // [s]
  long step() const { return step_; }

  const Scene &scene() const { return scene_; }
  const Projectile &projectile() const { return *projectile_; }
  const ContactRecord &reaction() const
  {
    return reaction_;
  } // of all plates, at the last evaluate()
  const std::vector<std::unique_ptr<PeridynamicBody>> &plates() const { return plates_; }
  /// Per plate; null if it is peridynamic throughout.
  const std::vector<std::unique_ptr<CoupledPlate>> &coupled_plates() const
  {
    return coupled_plates_;
  }
  const std::vector<PlateZone> &zones() const { return zones_; } // per plate
  /// Per plate; null if it is peridynamic throughout.
  const std::vector<std::unique_ptr<AdaptiveZone>> &adaptive_zones() const
  {
    return adaptive_zones_;
  }
  const MaterialParameters &material(std::size_t plate) const;
  double critical_stretch(std::size_t plate) const; // [-]

  /// Lower and upper corner of all plates in the reference configuration, mirrored half included
  /// [m].
  std::pair<Vector3, Vector3> target_box() const;

  /// Collective; after evaluate(true), before advance().
  EnergyBalance energies() const;
  /// Of the half step before the present time. Collective.
  MomentumBalance momenta() const;
  double broken_bonds() const; // each once, both halves; collective
  /// Box around the damaged points of a plate in the reference configuration, of the model as
  /// computed [m]; low > high if there are none. Collective.
  std::pair<Vector3, Vector3> damaged_box(std::size_t plate) const;
  double n_points() const; // of the full or half model as computed; collective
  double n_bonds() const;  // intact now, of the half model as computed; collective

  /// Throws RunError naming point, field and time if a field of this or another rank is not finite.
  /// Collective.
  void check_finite() const;
  /// "Point (x, y, z) of plate n is the fastest, at v m/s." Collective.
  std::string describe_fastest_point() const;

  PointFrame points() const; // owned by this rank
  SurfaceFrame surface() const { return projectile_->surface(); }
  ElementFrame elements() const; // owned by this rank

  /// What limits the step, for the user.
  struct TimeStepInfo
  {
    double frequency;        // largest of the bonds [rad/s]
    double contact_share;    // of the squared frequency that contact adds [-]
    double seconds_per_step; // measured, forces only [s]
    double plates_dt;        // the step that the plates alone would allow [s]
    double projectile_dt;    // the same of a deformable projectile; infinite if rigid [s]
  };
  TimeStepInfo time_step_info() const { return time_step_info_; }
  /// Of each plate alone, without contact.
  const std::vector<FrequencyEstimate> &frequencies() const { return frequencies_; }

private:
  void build_plates();
  void build_projectile();
  void choose_time_step();
  /// Of all plates, whose elastic force evaluations take so long [s].
  void start_relaxation(const std::vector<double> &elastic_seconds);

  MPI_Comm communicator_;
  Scene scene_;
  double multiplicity_; // 2 with a symmetry plane
  std::vector<PlateZone> zones_;
  std::vector<std::unique_ptr<PeridynamicBody>> plates_;
  std::vector<std::unique_ptr<CoupledPlate>> coupled_plates_;
  std::vector<std::unique_ptr<AdaptiveZone>> adaptive_zones_;
  std::vector<FractureEnergy> fractures_; // per plate
  std::unique_ptr<ShortRangeContact> debris_;
  std::unique_ptr<FrictionLaw> friction_law_;
  std::unique_ptr<Projectile> projectile_;
  ContactRecord reaction_;
  TimeStepInfo time_step_info_;
  std::vector<FrequencyEstimate> frequencies_;
  double time_ = 0., dt_ = 0.;
  long step_             = 0;
  double initial_energy_ = 0.;
};

/// s_c from the material: given, or from the energy release rate on this stencil [-].
double critical_stretch(const MaterialParameters &material, const Stencil &stencil);
} // namespace ricochet
