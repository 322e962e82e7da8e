// SPDX-License-Identifier: LGPL-2.1-or-later
// All that a run is made of, as plain numbers in SI: what the parameter file says after it has been
// read and checked. Axes: x along the plate and the flight, y across (the mirror plane is y = 0), z
// up; the first plate's upper face is z = 0, its near edge x = 0.
#pragma once

#include "ricochet/contact/friction_laws.h"
#include "ricochet/coupling/clamped_sides.h"
#include "ricochet/coupling/coupling_method.h"
#include "ricochet/geometry/body_of_revolution.h"
#include "ricochet/geometry/cutouts.h"
#include "ricochet/geometry/hex_solid.h"
#include "ricochet/materials/bond_law.h"
#include "ricochet/materials/flow_law.h"
#include "ricochet/materials/influence_function.h"
#include "ricochet/materials/relaxation.h"

#include <array>
#include <string>
#include <vector>

namespace ricochet
{
/// Of a section 'Material NAME'.
struct MaterialParameters
{
  std::string name;        // by which plates ask for it
  std::string bond_model;  // one of the names in materials/bond_laws.h
  double density;          // rho [kg/m^3]
  double bulk_modulus;     // K [Pa]
  double shear_modulus;    // mu [Pa], the instantaneous one
  double critical_stretch; // s_c [-]; 0: not given, derive from the energy release rate
  double energy_release;   // G_c [J/m^2]; 0: not given
  RelaxationSeries relaxation        = {}; // of the shear modulus, as given
  HistoryPrecision history_precision = HistoryPrecision::single_precision; // of the bonds
  bool cracks_push                   = true; // broken bonds resist compression until they part
  FlowLaw flow                       = {};   // in shear under pressure
  double parting_extension           = usual_parting_extension; // of broken bonds [spacings]
};

/// Of a section 'Plate N'.
struct PlateParameters
{
  double length;                        // along the flight [m]
  double width;                         // across it, the full one, also with the symmetry plane [m]
  double thickness;                     // [m]
  double gap;                           // distance to the plate above [m]
  double spacing;                       // dx [m]
  double horizon_ratio;                 // m = delta/dx [-]
  InfluenceFunction influence_function; // omega
  std::string material;                 // name of a MaterialParameters
  /// With ZoneKind::boxes: columns through the plate, x from and to, y from and to [m].
  std::vector<std::array<double, 4>> zone_boxes = {};
  bool absorbing_edges                          = false; // waves leave through the side faces
  ClampedSides clamped_sides                    = ClampedSides::none; // which edges are held
  double clamp_width                            = 0.;                 // [m]; 0: not given
  Cutouts cutouts      = {}; // holes, notches and cracks it has from the start
  // Of the joint to the plate above, if there is one:
  double joint_tension = 0.; // strength [Pa]; 0: they only touch
  double joint_shear   = 0.; // likewise [Pa]; 0: that under tension

  /// Whether it is joined to the plate above.
  bool has_joint() const { return joint_tension > 0.; }

  /// Of the frame that is held along the clamped sides: one horizon unless given [m].
  double held_width() const { return clamp_width > 0. ? clamp_width : horizon_ratio * spacing; }
};

/// Which part of the plates is peridynamic; finite elements carry the rest.
enum class ZoneKind
{
  everything,
  automatic, // the corridor of the impact, or its beginning if the zone is adaptive
  boxes,
  none // finite elements alone: elastic, nothing breaks
};

/// Of the section 'Coupling'.
struct ZoneParameters
{
  ZoneKind kind             = ZoneKind::everything; // which part is peridynamic
  bool adaptive             = false;                // grows ahead of damage
  bool grows_everywhere     = false;                // and not only in the corridor of the impact
  double conversion_stretch = 0.5; // of the critical stretch; beyond, near the interface, it grows
  CouplingParameters coupling;     // how points and elements are tied
  int coarsening_levels = -1;      // of the elements; -1: what the plate's points allow, at most 2
  bool full_quadrature  = false;   // eight points per element instead of one
  double hourglass_coefficient = 1.; // [-], see FiniteElementBody::Options

  /// Whether finite elements carry a part of the plates, or all of them.
  bool has_elements() const { return kind != ZoneKind::everything; }
};

/// What a projectile is computed as.
enum class ProjectileModel
{
  rigid,
  modal, // and its lowest eigenmodes
  finite_elements,
  peridynamic_nose, // with a shank of finite elements
  peridynamic
};

/// Of the section 'Projectile'.
struct ProjectileParameters
{
  BodyOfRevolution::Shape shape;                      // undeformed
  double mass;                                        // [kg], of the whole projectile
  ProjectileModel model     = ProjectileModel::rigid; // what it is computed as
  bool driven               = false; // keeps its velocity whatever it meets; rigid ones only
  // Of a deformable one:
  double youngs_modulus     = 0.; // [Pa]
  double poissons_ratio     = 0.; // [-]
  double yield_stress       = 0.; // of a modal one, beyond which the user is warned; 0: none [Pa]
  double spacing            = 0.; // dx of the points of a peridynamic one [m]
  double peridynamic_length = 0.; // of a peridynamic nose, from the tip [m]
  int modes                 = 0;  // of a modal one; 0: as many as cost no time step
  int refinement            = 2;  // of the generated mesh, from 1
  HexSolid mesh = {}; // read from a file, axis along x; no cells: generated from the shape
};

/// Of the section 'Impact'.
struct ImpactParameters
{
  double speed;           // [m/s]
  double incidence_angle; // between the velocity and the plate surface [rad]
  double attack_angle;    // between axis and velocity, positive = nose up [rad]
  double entry_x;         // distance of the entry point from the near edge [m]
  double entry_y;         // distance of the entry point from the mid-plane y = 0 [m]
  double clearance;       // between the lowest point of the projectile and the plate at t = 0 [m]
  double yaw_angle = 0.;  // of the axis out of the plane of flight, positive towards +y [rad]
  double spin      = 0.; // about the axis, positive: right-handed along the tip's direction [rad/s]
};

/// Of the sections 'Projectile N' and 'Impact N': one projectile and how it arrives.
struct Shot
{
  ProjectileParameters projectile; // what flies
  ImpactParameters impact;         // how it arrives
};

/// Of the section 'Contact'.
struct ContactParameters
{
  double stiffness_factor;       // k = factor * E * dx per point [-]
  FrictionParameters friction;   // law of the projectile on the plates, with its constants
  double regularisation_speed;   // below it the friction falls linearly to zero [m/s]
  double shank_resistance;       // A, target resistance on the shank [Pa]
  double shank_contact_fraction; // k, 0 switches shank friction off [-]
  double debris_factor;        // of the short-range stiffness 18 K/(pi delta^4), 0 switches off [-]
  double debris_friction = 0.; // of points on points, in units of the projectile's; 0: none [-]
  std::string search = "linked cells"; // one of contact_search_names() in contact/contact_search.h
};

/// Of the section 'Time'.
struct TimeParameters
{
  double end_time;      // the run ends here at the latest [s]
  double safety_factor; // dt = safety * 2/omega_max [-]
  bool stop_early;      // end when the outcome is decided
  double free_time;     // free of contact this long counts as decided [s]
  double wall_limit =
      0.; // the run is interrupted after so long on the clock on the wall [s]; 0: never
};

/// Of the section 'Output'.
struct OutputParameters
{
  std::string directory;                    // results folder
  double frame_interval;                    // between point and surface files [s]; 0: none
  double history_interval;                  // between history rows [s]
  bool vtu;                                 // write files for ParaView
  bool pictures;                            // draw PNGs at the end
  bool report                       = true; // write report.html at the end
  std::string reference_data        = {};   // file with somebody else's data, or ""
  /// Of the section's picture, ascending [s]; none: evenly spaced.
  std::vector<double> picture_times = {};
  // Between checkpoints [s]; 0: none.
  double checkpoint_interval        = 0.; // simulated
  double checkpoint_wall_interval   = 0.; // on the clock on the wall
};

struct Scene
{
  std::string title;                         // of the results
  bool symmetric;                            // mirror plane y = 0: only y > 0 is modelled
  ProjectileParameters projectile;           // section Projectile
  ImpactParameters impact;                   // section Impact
  std::vector<PlateParameters> plates;       // from top to bottom
  std::vector<MaterialParameters> materials; // in the order of the file
  ZoneParameters zone;                       // section Coupling
  ContactParameters contact;                 // section Contact
  TimeParameters time;                       // section Time
  OutputParameters output;                   // section Output
  std::vector<Shot> further_shots = {};      // sections Projectile N and Impact N, from 2 on

  std::size_t n_projectiles() const { return 1 + further_shots.size(); } // in all
  /// From 0, the first.
  const ProjectileParameters &projectile_at(const std::size_t i) const
  {
    return i == 0 ? projectile : further_shots[i - 1].projectile;
  }
  /// Likewise.
  const ImpactParameters &impact_at(const std::size_t i) const
  {
    return i == 0 ? impact : further_shots[i - 1].impact;
  }
  /// The same scene with this projectile alone.
  Scene with_only(const std::size_t i) const
  {
    Scene scene      = *this;
    scene.projectile = projectile_at(i);
    scene.impact     = impact_at(i);
    scene.further_shots.clear();
    return scene;
  }
};
} // namespace ricochet
