// SPDX-License-Identifier: LGPL-2.1-or-later
// Brings the fields of a body from one distribution of its planes over the ranks to another.
#pragma once

#include "ricochet/peridynamics/lattice.h"

#include <mpi.h>
#include <type_traits>
#include <utility>
#include <vector>

namespace ricochet
{
class PlaneExchange
{
public:
  /// Two lattices of one body that differ in their shares alone; both must outlive this object.
  PlaneExchange(const MPI_Comm communicator, const Lattice &from, const Lattice &to) :
    communicator_(communicator), from_(from), to_(to)
  {
  }

  /// Every local plane of the new share, ghosts too, takes over what its old owner has in it.
  /// `per_point`: entries of the array per entry of a lattice field, a multiple of 1/8. Collective.
  template <class T>
  void move(const T *from, T *to, const double per_point = 1.) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "sent as bytes");
    move_bytes(reinterpret_cast<const char *>(from), reinterpret_cast<char *>(to),
               per_point * sizeof(T));
  }

  /// The same in place: the array gets the size that the new share needs, zero where no old owner
  /// is.
  template <class T>
  void move(std::vector<T> &field, const double per_point = 1.) const
  {
    std::vector<T> moved(static_cast<std::size_t>(static_cast<double>(to_.size()) * per_point),
                         T{});
    move(field.data(), moved.data(), per_point);
    field = std::move(moved);
  }

private:
  void move_bytes(const char *from, char *to, double bytes_per_point) const;

  MPI_Comm communicator_;
  const Lattice &from_, &to_;
};
} // namespace ricochet
