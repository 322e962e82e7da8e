// SPDX-License-Identifier: LGPL-2.1-or-later
// Fills the ghost planes of a lattice from the two neighbouring ranks with non-blocking messages.
#pragma once

#include "ricochet/peridynamics/lattice.h"

#include <initializer_list>
#include <mpi.h>

namespace ricochet
{
class Halo
{
public:
  /// Collective in use: every rank of the communicator must call exchange() the same number of
  /// times. `body`: its number, which keeps the messages of several bodies apart.
  Halo(MPI_Comm communicator, const Lattice &lattice, int body);

  /// Copies the neighbours' outermost owned planes, as many as the stencil reaches, of each field
  /// into this rank's ghost planes. Fields: Lattice::size() numbers each.
  void exchange(std::initializer_list<double *> fields);

private:
  MPI_Comm communicator_;
  int left_, right_; // ranks or MPI_PROC_NULL
  int tag_;
  std::ptrdiff_t count_; // entries of the exchanged planes of one field
  std::ptrdiff_t owned_begin_, owned_end_;
  std::vector<double> send_left_, send_right_, receive_left_, receive_right_;
};
} // namespace ricochet
