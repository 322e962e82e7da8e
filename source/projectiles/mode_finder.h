// SPDX-License-Identifier: LGPL-2.1-or-later
// The lowest modes of a projectile's mesh, found once and kept in the user's cache folder
// ($XDG_CACHE_HOME/ricochet or ~/.cache/ricochet; none without HOME), under a hash of all that they
// depend on. The first rank finds them and sends them to all: they are the same to the last bit
// everywhere, also on machines of different processors.
#pragma once

#include "ricochet/finite_elements/free_vibration.h"

#include <array>
#include <filesystem>
#include <mpi.h>

namespace ricochet
{
/// What is known of a mesh.
struct ProjectileModes
{
  FreeModes modes;
  /// f^T K^+ f of loads that were asked for, without rigid motion [m/N if f is of size 1]: what all
  /// modes together would give.
  std::array<double, 2> compliance;
};

class ModeFinder
{
public:
  /// Forces on all nodes, three numbers each [N].
  using Loads = std::array<std::vector<double>, 2>;

  /// `mesh` at rest must outlive this object.
  ModeFinder(MPI_Comm communicator, const HexahedralBody &mesh, Loads loads) :
    communicator_(communicator), mesh_(mesh), loads_(std::move(loads))
  {
  }

  /// The n lowest, from the cache if it has them. Throws InputError as FreeVibration does.
  /// Collective.
  ProjectileModes lowest(int n);

private:
  std::string on_this_rank(int n);
  ProjectileModes compute(int n);
  std::string key(int n) const;

  MPI_Comm communicator_;
  const HexahedralBody &mesh_;
  Loads loads_;
  std::unique_ptr<FreeVibration> vibration_; // when needed
};

/// Where modes are kept; empty: nowhere.
std::filesystem::path mode_cache();
} // namespace ricochet
