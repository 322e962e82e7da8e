// SPDX-License-Identifier: LGPL-2.1-or-later
// One peridynamic body: bonds broken first, then dilatation, then forces, with the halo and the
// mirror images kept up to date. Owns the body's lattice and state. With a zone only the points in
// and around it exist; those around it are slaved: somebody else (coupling/) sets their motion and
// collects their forces.
//
// Microelastic brittle solid: Silling and Askari 2005, Computers and Structures 83; linear
// peridynamic solid: Silling et al. 2007, J. Elasticity 88; its relaxation: bond_viscosity.h.
#pragma once

#include "ricochet/bodies/body.h"
#include "ricochet/peridynamics/bond_blocks.h"
#include "ricochet/peridynamics/bond_damage.h"
#include "ricochet/peridynamics/bond_flow.h"
#include "ricochet/peridynamics/bond_tables.h"
#include "ricochet/peridynamics/bond_viscosity.h"
#include "ricochet/peridynamics/halo.h"
#include "ricochet/peridynamics/lattice_state.h"
#include "ricochet/peridynamics/peridynamic_material.h"

#include <array>
#include <memory>
#include <mpi.h>
#include <vector>

namespace ricochet
{
class FractureEnergy;
class StretchedPoints;

class PeridynamicBody : public Body
{
public:
  /// Collective. `number` of the body, from 0, keeps the messages of several bodies apart.
  /// `instruction_set` as in lattice_kernel(). The zone, if any, must outlive this object. Throws
  /// InputError if the processor lacks the instruction set, if the law cannot represent the moduli,
  /// or as Lattice does.
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

  /// Begins flow, too. Throws InputError if the law or a branch cannot relax, or the law not flow.
  void start_relaxation(double dt) override;
  bool relaxes() const override { return history_ != nullptr; }
  /// Null if the body is elastic.
  const BondViscosity *history() const { return history_.get(); }
  /// The same, to be set from outside.
  BondViscosity *history() { return history_.get(); }

  /// Null if the material does not flow.
  const BondFlow *flow() const { return flow_.get(); }

  /// After the zone has grown by cells whose layers have changed between the planes first <= x <
  /// last (global): new points and bonds appear, at rest in the reference configuration, and slaved
  /// ones become free. What is broken stays broken.
  void follow_zone(int first, int last);
  /// Components 11, 22, 33, 23, 13, 12 of a tensor per point, Lattice::size() numbers each, and of
  /// a branch each.
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
  void exchange_state(StateArchive &archive) override;
  std::string first_not_finite() const override;
  /// Of the ranks that share the points.
  MPI_Comm communicator() const { return communicator_; }

  /// Where the points are.
  const Lattice &lattice() const { return lattice_; }
  /// All that moves.
  LatticeState &state() { return state_; }
  /// Likewise.
  const LatticeState &state() const { return state_; }
  /// As it was given.
  const PeridynamicMaterial &material() const { return material_; }
  /// Of this processor.
  const LatticeKernel &kernel() const { return *kernel_; }
  /// Per offset.
  const std::vector<BondConstants> &bond_constants() const { return tables_.breakable_constants(); }
  double point_stiffness() const { return tables_.breakable().point_stiffness; } // [J]
  double cracked_share() const { return tables_.breakable().cracked_share; } // see BondTable [-]
  double point_mass() const { return mass_; }                                // [kg]
  double point_volume() const { return mass_ / material_.density; }          // [m^3]

  /// Which bonds there were and which have broken.
  const BondDamage &bond_damage() const { return damage_; }
  /// Cracks that the body begins with: breaks all bonds for whose ends, in the reference
  /// configuration, `crosses` says so. They count as damage, and release nothing: neither are they
  /// in n_broken_bonds(). Returns how many ends they have, of all ranks. Collective.
  double sever(const std::function<bool(const Vector3 &, const Vector3 &)> &crosses);

  /// What the last break_bonds() broke, see BrokenBondLog::for_each().
  template <class Visitor>
  void for_each_newly_broken_bond(Visitor &&visit) const
  {
    damage_.log().for_each(visit);
  }
  /// Likewise what it let part.
  template <class Visitor>
  void for_each_newly_parted_bond(Visitor &&visit) const
  {
    damage_.log().for_each_parted(visit);
  }
  /// As BondDamage.
  std::uint8_t parted_bonds(const std::int64_t block, const std::size_t k) const
  {
    return damage_.parted_bonds(block, k);
  }
  /// As BondDamage.
  std::uint8_t broken_bonds(const std::int64_t block, const std::size_t k) const
  {
    return damage_.broken_bonds(block, k);
  }
  /// Of an owned point: share of its family that is broken [-].
  double damage(const std::ptrdiff_t index) const { return damage_.damage(index); }
  /// Whether a bond of it has broken.
  bool is_damaged(const std::ptrdiff_t index) const { return damage_.is_damaged(index); }
  /// Whether it may meet points of its own body: it is damaged, or at the rim of a cut-out.
  bool is_open(const std::ptrdiff_t index) const { return damage_.is_open(index); }
  // Counts of bonds are, like energies and momenta, of the body as computed: multiplicity() times
  // as many has the whole one.
  /// Bonds of the body, and the same with broken ones; each counted once, over all ranks, a
  /// mirrored one half. Collective, slow.
  double count_bonds() const { return damage_.count_intact(communicator_); }
  /// Broken ones included.
  double count_sound_bonds() const { return damage_.count_sound(communicator_); }
  /// Bonds broken and booked so far, likewise. Collective.
  double n_broken_bonds() const;

  /// Owned points with an intact bond stretched beyond `stretch` [-] among the blocks given, each
  /// perhaps several times: a look ahead, nothing breaks.
  std::vector<std::ptrdiff_t> points_stretched(double stretch,
                                               const std::vector<Lattice::BlockRange> &blocks);

  /// The zone's cell of a point of the lattice; images belong to their original's.
  Zone::Cell cell_of(const std::ptrdiff_t index) const
  {
    const auto c = lattice_.coordinates(index);
    return lattice_.zone()->cell_of(c[0], c[1] < 0 ? -1 - c[1] : c[1], c[2]);
  }

private:
  void find_blocks();
  void compute_dilatation(const BondTable &table);
  void start_flow(double dt);
  void add_bond_forces(bool energy);
  void add_relaxing_forces(const ForceRequest &request);

  MPI_Comm communicator_;
  int number_;
  Lattice lattice_;
  LatticeState state_;
  PeridynamicMaterial material_;
  Halo halo_;
  const LatticeKernel *kernel_;
  BondTables tables_;
  double mass_; // of a point [kg]
  BondDamage damage_;
  BondBlocks blocks_;
  bool has_dilatation_ = false; // of the present positions, by break_bonds()
  bool in_step_        = false; // a dilatation has been computed since the last end_step()
  std::unique_ptr<BondViscosity> history_;
  std::unique_ptr<BondFlow> flow_;
  std::vector<std::uint8_t> new_bonds_; // that follow_zone() has added, for continue_history()
  std::unique_ptr<FractureEnergy> fracture_;
  std::unique_ptr<StretchedPoints> stretched_points_;
};
} // namespace ricochet
