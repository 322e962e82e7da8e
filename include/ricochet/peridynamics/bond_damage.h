// SPDX-License-Identifier: LGPL-2.1-or-later
// Which bonds of a body have broken: those it started with, less those that are left. Damage of a
// point is the share of its family that is gone (Silling and Askari 2005).
//
// Bonds are bits, laid out as in LatticeArrays::bonds: one byte per block of 8 points and offset,
// [block][offset]; bit l is the bond from point 8 block + l.
#pragma once

#include "ricochet/peridynamics/broken_bond_log.h"
#include "ricochet/peridynamics/lattice_state.h"

#include <array>
#include <functional>
#include <mpi.h>
#include <vector>

namespace ricochet
{
class PlaneArchive;
class PlaneExchange;

class BondDamage
{
public:
  /// Sound is what `state` has now. Both must outlive this object.
  BondDamage(const Lattice &lattice, const LatticeState &state, const LatticeKernel &kernel);

  /// What broke in the last step; whoever breaks bonds keeps it.
  BrokenBondLog &log() { return log_; }
  /// What the last step has broken.
  const BrokenBondLog &log() const { return log_; }
  /// The ends of what is in the log are damaged from now on.
  void mark_damaged();

  /// Breaks all bonds for whose ends, in the reference configuration, `crosses` says so; `state` is
  /// that of the constructor. Returns how many ends of them this rank owns.
  double sever(LatticeState &state,
               const std::function<bool(const Vector3 &, const Vector3 &)> &crosses);

  /// Bonds that have appeared between the planes first <= x < last (global) of a lattice that has
  /// followed its zone are sound, and intact in `state`. What is broken stays broken. Returns the
  /// new ones, of all blocks.
  std::vector<std::uint8_t> follow_zone(int first, int last, LatticeState &state);
  /// The planes are moving to other ranks: takes over what belongs to the new share, of which
  /// `sound` are the bonds that there would be without damage. Empties the log.
  void redistribute(const PlaneExchange &planes, const Lattice &share,
                    std::vector<std::uint8_t> sound, const LatticeKernel &kernel);

  /// Saves or restores which points are damaged; the bonds are the state's. Collective.
  void exchange_state(PlaneArchive &planes);

  /// Of all blocks.
  const std::vector<std::uint8_t> &sound_bonds() const { return sound_; }
  /// Bit l: the bond k of point 8 block + l is broken.
  std::uint8_t broken_bonds(const std::int64_t block, const std::size_t k) const
  {
    const std::size_t at = block * shifts_.size() + k;
    return sound_[at] & ~state_.arrays.bonds[at];
  }
  /// The same of those that carry nothing any more.
  std::uint8_t parted_bonds(const std::int64_t block, const std::size_t k) const
  {
    const std::uint8_t broken = broken_bonds(block, k), *const cracked = state_.arrays.cracked;
    return cracked == nullptr ? broken : broken & ~cracked[block * shifts_.size() + k];
  }
  /// Calls visit(p, q, k) for every broken bond k from point p to q, in ascending order of blocks,
  /// then offsets, then points.
  template <class Visitor>
  void for_each_broken_bond(Visitor &&visit) const;

  /// Of an owned point: share of its family that is broken [-].
  double damage(std::ptrdiff_t index) const;
  /// Whether a bond of a point has broken on this rank: of points that are not owned some may be
  /// unknown.
  bool is_damaged(const std::ptrdiff_t index) const { return (open_[index] & damaged) != 0; }
  /// Whether it may meet points of its own body: it is damaged, or it lies at the rim of what was
  /// cut out of the body. With the same reserve.
  bool is_open(const std::ptrdiff_t index) const { return open_[index] != 0; }

  /// Bonds that are left, and those there would be without damage; each once, over all ranks, a
  /// mirrored one half. Collective, slow.
  double count_intact(MPI_Comm communicator) const;
  /// All bonds that there have been, each once, over all ranks. Collective.
  double count_sound(MPI_Comm communicator) const;

private:
  int family_size(std::ptrdiff_t index, const std::uint8_t *bonds) const;
  void count_families(const Lattice &lattice);
  void find_rims();
  bool spans_cutout(const std::array<int, 3> &from, const Stencil::Offset &o) const;

  static constexpr char damaged = 1, at_rim = 2;

  const Lattice &lattice_;
  const LatticeState &state_;
  std::vector<std::int64_t> shifts_;
  BrokenBondLog log_;
  std::vector<std::uint8_t> sound_;
  std::vector<std::uint16_t> sound_family_; // bonds of each owned point in sound_
  std::vector<char> open_;                  // per point: damaged, at_rim
};

template <class Visitor>
void BondDamage::for_each_broken_bond(Visitor &&visit) const
{
  const std::ptrdiff_t last = lattice_.owned_end() / Lattice::block_size;
  for (std::ptrdiff_t block = 0; block < last; ++block)
    for (std::size_t k = 0; k < shifts_.size(); ++k)
      if (const unsigned int gone = broken_bonds(block, k))
        for (int lane = 0; lane < Lattice::block_size; ++lane)
          if ((gone >> lane) & 1)
          {
            const std::ptrdiff_t p = block * Lattice::block_size + lane;
            visit(p, p + static_cast<std::ptrdiff_t>(shifts_[k]), k);
          }
}
} // namespace ricochet
