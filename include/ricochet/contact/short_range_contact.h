// SPDX-License-Identifier: LGPL-2.1-or-later
// Short-range contact of points that no bond connects (Macek and Silling 2007): debris does not
// interpenetrate, and bodies touch and rub. Per pair the forces of contact/pair_law.h on both
// points, equal and opposite, with
//   depth  d - r for r < d,   d = min(0.9 |X_j - X_i|, 1.35 dx)
//   k      factor 18 K V^2 / (pi delta^5)
// and friction bounded so that it never drives points back. Two points of one body touch if their
// bond is broken, or if they never had one and at least one of them is damaged or lies at the rim
// of a hole or notch; points of different bodies always do.
//
// Points do not rotate, so friction between two of them keeps linear momentum to rounding but not
// angular momentum: what is missing is the couple of the two forces, whose arm is r.
#pragma once

#include "ricochet/bodies/interaction.h"
#include "ricochet/contact/contact_bodies.h"
#include "ricochet/contact/friction_law.h"
#include "ricochet/contact/friction_work.h"

#include <memory>
#include <string>

namespace ricochet
{
class ContactPairs;

class ShortRangeContact : public Interaction
{
public:
  /// Of points on points.
  struct Friction
  {
    const FrictionLaw *law = nullptr; // outlives the contact; none: frictionless
    double factor          = 1.;      // of the law's coefficient [-]
    double regularisation_speed =
        0.; // below it the force falls linearly to zero [m/s], > 0 if used
  };

  /// `factor` 0 switches the contact off. The bodies must outlive this object. `mirrored`: y = 0 is
  /// a symmetry plane. `search`: one of contact_search_names(); throws InputError for another one.
  ShortRangeContact(MPI_Comm communicator, const Bodies &bodies, double factor, bool mirrored,
                    const std::string &search = "linked cells");
  /// The same with friction.
  ShortRangeContact(MPI_Comm communicator, const Bodies &bodies, double factor, bool mirrored,
                    const std::string &search, const Friction &friction);
  ~ShortRangeContact() override;

  /// Adds contact forces to the bodies' forces. `dt`: the coming step [s]; it tells how far points
  /// may get before the pairs are searched again, and how much friction it takes to stop them.
  /// Collective.
  void add_forces(double dt) override;

  /// Adds the work of friction in this step to the ledger: call after the bodies' kick, which is
  /// `dt` long [s].
  void record_work(double dt) override;

  /// Energy stored in the repulsion, both halves [J]. Collective.
  double energy() const override;
  /// Work of friction on the points so far, both halves [J]; the heat is minus that. Collective.
  double friction_work() const override;

  /// Pairs that touch; a point and an image count as half of one. Collective.
  double n_touching() const;
  /// Points have appeared in a body, or changed their flat index or rank, since the last
  /// add_forces(); the same on all ranks.
  void bodies_changed() override;
  void exchange_state(StateArchive &archive) override;
  /// How often all pairs have been searched, and how many points have been searched alone.
  long n_searches() const;
  long n_single_searches() const; // so far, on this rank

  /// Upper bound of the squared frequency which this contact adds to a point of the body [1/s^2].
  double squared_frequency(const PeridynamicBody &body) const;

private:
  /// One of two points that touch.
  struct End
  {
    std::ptrdiff_t flat; // < 0: not a point of this rank
    int body;
  };
  /// Two points that touch now, and how.
  struct ActiveContact
  {
    End first, second;
    Vector3 apart, velocity; // of the second relative to the first [m], [m/s]
    double distance;         // at which they begin to touch [m]
    double stiffness;        // [N/m]
    double mass;             // reduced one of the two [kg]
  };
  struct StoredEnergy
  {
    End first, second;
    double energy; // [J]
  };

  double stiffness(int body, int other_body) const; // k of a pair [N/m]
  void add_broken_bond_forces(std::size_t body, double dt);
  void add_non_bonded_forces(double dt);
  void add_pair_forces(const ActiveContact &contact, double dt);

  MPI_Comm communicator_;
  Bodies bodies_;
  double factor_;
  bool mirrored_;
  Friction friction_;
  std::vector<double> stiffness_; // k within each body [N/m]
  std::unique_ptr<ContactPairs> pairs_;
  std::vector<std::int32_t> touching_; // workspace
  std::vector<StoredEnergy> energies_; // of the pairs that touch
  std::vector<FrictionWork> work_;     // per body
};
} // namespace ricochet
