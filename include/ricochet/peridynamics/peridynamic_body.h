// SPDX-License-Identifier: LGPL-2.1-or-later
// The internal force of one peridynamic body: bonds broken first, then dilatation, then forces,
// with the halo and the mirror images kept up to date. Owns the body's lattice and state. With a
// zone only the points in and around it exist; those around it are slaved: somebody else
// (coupling/) sets their motion and collects their forces.
#pragma once

#include "ricochet/bodies/body.h"
#include "ricochet/peridynamics/bond_viscosity.h"
#include "ricochet/peridynamics/halo.h"
#include "ricochet/peridynamics/lattice_state.h"

#include <array>
#include <memory>
#include <mpi.h>
#include <optional>
#include <vector>

namespace ricochet
{
class FractureEnergy;

struct PeridynamicMaterial
{
  const BondLaw *law;
  double density;          // [kg/m^3]
  double bulk_modulus;     // [Pa]
  double shear_modulus;    // [Pa], the instantaneous one
  double critical_stretch; // s_c [-]; infinite: never breaks
  // Of the shear modulus; takes effect by start_relaxation().
  RelaxationSeries relaxation        = {};
  HistoryPrecision history_precision = HistoryPrecision::single_precision;
};

class PeridynamicBody : public Body
{
public:
  /// Collective. `number` of the body, from 0, keeps the messages of several bodies apart.
  /// `instruction_set` as in lattice_kernel(). The zone, if any, must outlive this object. Throws
  /// InputError if the processor lacks the instruction set or if the law cannot represent the
  /// moduli.
  PeridynamicBody(MPI_Comm communicator, int number, const Lattice::Box &box,
                  const Stencil &stencil, const PeridynamicMaterial &material,
                  const Lattice::Mask &mask = {}, const char *instruction_set = nullptr,
                  const Zone *zone = nullptr);
  ~PeridynamicBody() override;
  PeridynamicBody(const PeridynamicBody &)            = delete;
  PeridynamicBody &operator=(const PeridynamicBody &) = delete;

  double multiplicity() const override { return lattice_.box().mirror_y ? 2. : 1.; }

  void update_ghosts() override;
  /// Bonds stretched beyond their limit break; what the others say of the dilatation is kept for
  /// the compute_internal_forces() that follows.
  void break_bonds() override;
  void book_fracture(double dt) override;
  void compute_internal_forces(const ForceRequest &request) override;

  /// Throws InputError if the law or a branch cannot relax.
  void start_relaxation(double dt) override;
  bool relaxes() const override { return history_ != nullptr; }
  /// Null if the body is elastic.
  const BondViscosity *history() const { return history_.get(); }
  BondViscosity *history() { return history_.get(); }

  /// After the zone has grown by cells whose layers have changed between the planes first <= x <
  /// last (global): new points and bonds appear, at rest in the reference configuration, and slaved
  /// ones become free. What is broken stays broken.
  void follow_zone(int first, int last);
  /// Components 11, 22, 33, 23, 13, 12 of a tensor per point, and of a branch each.
  using TensorFields = std::vector<std::array<std::vector<double>, 6>>;
  /// After follow_zone() of a body that relaxes: the histories that bonds which have appeared take
  /// over, see BondViscosity::take_over(), at owned points. Collective.
  void continue_history(TensorFields &histories);

  /// Moves planes between the ranks, with everything that is known of their points: afterwards rank
  /// r owns plane_starts[r] <= x < plane_starts[r + 1]. Call between steps; flat indices change.
  /// Collective.
  void redistribute(const std::vector<int> &plane_starts);

  /// Of the free points.
  void advance(double kick, double drift) override;
  /// The dilatation of now becomes that of the step before, which fracture energy and relaxation
  /// ask for: part of advance(), and for who moves the points by other means. Looks between steps
  /// leave it alone; a second call does nothing.
  void end_step();

  /// The energy of each point counts so many times, besides the zone's share of it: per point,
  /// images too [-]. Needs a zone, and one that neither grows nor moves between ranks: both start
  /// from the zone's shares again.
  void scale_energy(const std::vector<double> &factor);

  /// Kinetic energy is that of free points.
  Energies energies(double dt) const override;
  /// Of the free points.
  Momenta momenta() const override;
  /// Everything at rest in the reference configuration, without forces. Collective.
  void rest();

  std::unique_ptr<Vibration> vibration() override;
  std::string first_not_finite() const override;
  MPI_Comm communicator() const { return communicator_; }

  const Lattice &lattice() const { return lattice_; }
  LatticeState &state() { return state_; }
  const LatticeState &state() const { return state_; }
  const PeridynamicMaterial &material() const { return material_; }
  const LatticeKernel &kernel() const { return *kernel_; }
  const std::vector<BondConstants> &bond_constants() const { return constants_; }
  double point_stiffness() const { return table_.point_stiffness; } // [J]
  double point_mass() const { return mass_; }                       // [kg]
  double point_volume() const { return mass_ / material_.density; } // [m^3]

  /// What the last break_bonds() broke; a bond with ends on two ranks stands on both.
  const std::vector<BrokenBonds> &broken() const { return broken_; }
  std::size_t n_broken_entries() const { return n_broken_; }
  /// Calls visit(p, q, k) for the bond k from point p to q of each of them.
  template <class Visitor>
  void for_each_newly_broken_bond(Visitor &&visit) const;

  /// Bonds of the body; each counted once, over all ranks, a mirrored one half. Collective, slow.
  double count_bonds() const;
  /// Bonds broken so far, each once, of both halves of a symmetric body. Collective.
  double n_broken_bonds() const;
  /// The same, broken ones included.
  double count_sound_bonds() const;

  /// Owned points with an intact bond stretched beyond `stretch` [-] among the blocks given, each
  /// perhaps several times: a look ahead, nothing breaks.
  std::vector<std::ptrdiff_t> points_stretched(double stretch,
                                               const std::vector<Lattice::BlockRange> &blocks);

  /// Calls visit(p, q, k) for every broken bond k from point p to q, in ascending order.
  template <class Visitor>
  void for_each_broken_bond(Visitor &&visit) const;
  /// Bit l: the bond k of point 8 block + l is broken.
  std::uint8_t broken_bonds(const std::int64_t block, const std::size_t k) const
  {
    const std::size_t at = block * shifts_.size() + k;
    return initial_bonds_[at] & ~state_.arrays.bonds[at];
  }

  /// The zone's cell of a point of the lattice; images belong to their original's.
  Zone::Cell cell_of(const std::ptrdiff_t index) const
  {
    const auto c = lattice_.coordinates(index);
    return lattice_.zone()->cell_of(c[0], c[1] < 0 ? -1 - c[1] : c[1], c[2]);
  }

  /// Damage of an owned point: share of its family that is broken [-].
  double damage(std::ptrdiff_t index) const;
  bool is_damaged(const std::ptrdiff_t index) const { return damaged_[index]; }

private:
  int family_size(std::ptrdiff_t index, const std::uint8_t *bonds) const;
  void set_families();
  void find_bond_ranges();
  void compute_dilatation(const BondTable &table);
  void weigh_dilatation();
  void mark_damaged();
  void add_bond_forces(bool energy);
  void add_relaxing_forces(const ForceRequest &request);

  MPI_Comm communicator_;
  int number_;
  Lattice lattice_;
  LatticeState state_;
  PeridynamicMaterial material_;
  Halo halo_;
  const LatticeKernel *kernel_;
  double mass_;
  std::vector<BondConstants> constants_, unbreakable_constants_;
  std::vector<int64_t> shifts_;
  BondTable table_, unbreakable_table_;
  std::unique_ptr<BondViscosity> history_;
  std::vector<std::uint8_t> initial_bonds_;
  std::vector<std::uint16_t> initial_family_; // bonds of each owned point at the start
  // Blocks with bonds; those of whole weight alone, and the others.
  std::vector<Lattice::BlockRange> bond_ranges_, whole_ranges_, weighted_ranges_;
  std::vector<char> damaged_;
  std::vector<BrokenBonds> broken_;
  std::vector<std::uint8_t> new_bonds_;     // that follow_zone() has added
  std::vector<std::uint8_t> watched_bonds_; // workspace of points_stretched()
  std::vector<double> watched_theta_;
  std::size_t n_broken_ = 0;
  bool has_dilatation_  = false; // of the present positions, by break_bonds()
  bool in_step_         = false; // a dilatation has been computed since the last end_step()
  std::unique_ptr<FractureEnergy> fracture_;
};

template <class Visitor>
void PeridynamicBody::for_each_newly_broken_bond(Visitor &&visit) const
{
  for (std::size_t i = 0; i < n_broken_; ++i)
    for (int lane = 0; lane < Lattice::block_size; ++lane)
      if ((broken_[i].points >> lane) & 1)
      {
        const std::ptrdiff_t p =
            static_cast<std::ptrdiff_t>(broken_[i].block) * Lattice::block_size + lane;
        visit(p, p + shifts_[broken_[i].offset], static_cast<std::size_t>(broken_[i].offset));
      }
}

template <class Visitor>
void PeridynamicBody::for_each_broken_bond(Visitor &&visit) const
{
  const std::ptrdiff_t last = lattice_.owned_end() / Lattice::block_size;
  for (std::ptrdiff_t block = 0; block < last; ++block)
    for (std::size_t k = 0; k < shifts_.size(); ++k)
      if (const unsigned int gone = broken_bonds(block, k))
        for (int lane = 0; lane < Lattice::block_size; ++lane)
          if ((gone >> lane) & 1)
            visit(block * Lattice::block_size + lane,
                  block * Lattice::block_size + lane + shifts_[k], k);
}
} // namespace ricochet
