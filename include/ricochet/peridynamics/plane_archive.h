// SPDX-License-Identifier: LGPL-2.1-or-later
// Between the planes of one body and an archive: the counterpart of PlaneExchange, with a file in
// the place of the old share.
#pragma once

#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/state_archive.h"
#include "ricochet/peridynamics/lattice.h"
#include "ricochet/peridynamics/plane_sums.h"

namespace ricochet
{
class PlaneArchive
{
public:
  /// `communicator` of the ranks that share the lattice: one alone if every rank has all of it.
  /// Both must outlive this object.
  PlaneArchive(StateArchive &archive, const MPI_Comm communicator, const Lattice &lattice) :
    archive_(archive), lattice_(lattice), first_(lattice.first_plane()),
    last_(first_ + lattice.n_planes()), last_saved_(last_)
  {
    if (size_of(communicator) < size_of(archive.communicator()) &&
        rank_in(archive.communicator()) > 0)
      last_saved_ = first_; // rank 0 has all of it as well
  }

  /// For what does not lie on planes.
  StateArchive &archive() { return archive_; }

  /// Owned planes are saved, all local ones of the body restored. `per_point`: entries of the array
  /// per entry of a lattice field, a multiple of 1/8. Collective.
  template <class T>
  void field(const std::string &name, T *const values, const double per_point = 1.)
  {
    static_assert(std::is_trivially_copyable_v<T>, "kept as bytes");
    const auto per_plane =
        static_cast<std::size_t>(static_cast<double>(lattice_.plane_stride()) * per_point);
    const int reach = lattice_.stencil().reach;
    archive_.planes(name, values, per_plane * sizeof(T),
                    {first_, last_saved_, first_ - reach, last_ + reach, lattice_.box().n[0]});
  }

  /// Sums are saved and restored where their planes are owned; they must be at home there.
  /// Collective.
  template <int n>
  void sums(const std::string &name, PlaneSums<n> &sums)
  {
    const int all = lattice_.box().n[0];
    archive_.planes(name, &sums[0], sizeof(sums[0]), {first_, last_saved_, 0, all, all});
    sums.keep(first_, last_);
  }

private:
  StateArchive &archive_;
  const Lattice &lattice_;
  int first_, last_, last_saved_; // planes that are owned, and that this rank saves
};
} // namespace ricochet
