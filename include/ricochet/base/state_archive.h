// SPDX-License-Identifier: LGPL-2.1-or-later
// The state from which a run can go on. Whoever moves shows to an archive, by name, all that it
// cannot work out anew from the scene; the same lines save and restore, so that nothing can be
// saved and not restored. The archive does not know what it holds; where and how it keeps it is
// somebody else's affair (output/checkpoint_file.h).
//
// What is kept does not depend on the number of ranks. All functions are
// collective and throw FileError on all ranks alike.
#pragma once

#include "ricochet/base/vector.h"

#include <cstdint>
#include <mpi.h>
#include <string>
#include <type_traits>
#include <vector>

namespace ricochet
{
class StateArchive
{
public:
  /// Of all ranks that share the state.
  explicit StateArchive(const MPI_Comm communicator) : communicator_(communicator) {}
  virtual ~StateArchive()                       = default;
  StateArchive(const StateArchive &)            = delete;
  StateArchive &operator=(const StateArchive &) = delete;

  /// Whether state comes out of the archive and overwrites what is there; else it goes in, and
  /// nothing changes.
  virtual bool is_restoring() const = 0;
  /// Of all ranks that share the state.
  MPI_Comm communicator() const { return communicator_; }

  /// Names within its life stand under this one, as in a folder.
  class Group
  {
  public:
    /// From now on; the archive must outlive it.
    Group(StateArchive &archive, const std::string &name) :
      archive_(archive), outer_(archive.prefix_)
    {
      archive_.prefix_ += name + "/";
    }
    ~Group() { archive_.prefix_ = outer_; }
    Group(const Group &)            = delete;
    Group &operator=(const Group &) = delete;

  private:
    StateArchive &archive_;
    std::string outer_;
  };

  /// A value that is the same on all ranks.
  template <class T>
  void common(const std::string &name, T &value)
  {
    static_assert(std::is_trivially_copyable_v<T>, "kept as bytes");
    common_bytes(prefix_ + name, reinterpret_cast<char *>(&value), sizeof(T));
  }
  /// Three numbers, likewise.
  void common(const std::string &name, Vector3 &value) { common(name, value.data(), 3); }
  /// As many as there are, likewise.
  template <class T>
  void common(const std::string &name, T *const values, const std::size_t n)
  {
    static_assert(std::is_trivially_copyable_v<T>, "kept as bytes");
    common_bytes(prefix_ + name, reinterpret_cast<char *>(values), n * sizeof(T));
  }
  /// As many as the archive has; likewise.
  template <class T>
  void common(const std::string &name, std::vector<T> &values)
  {
    common_of_any_size(name, values);
  }
  /// See above.
  void common(const std::string &name, std::string &text) { common_of_any_size(name, text); }

  /// How the planes of a body lie on a rank: those it owns, those that it has room for, which may
  /// stand out from the body, and how many there are; first <= plane < last.
  struct PlaneShare
  {
    int first, last;             // owned
    int first_local, last_local; // with ghosts
    int n;                       // of the body
  };
  /// So many bytes per plane, beginning with the first local one. What is owned is saved; all local
  /// planes of the body are restored.
  void planes(const std::string &name, void *const values, const std::size_t bytes_per_plane,
              const PlaneShare &share)
  {
    planes_bytes(prefix_ + name, static_cast<char *>(values), bytes_per_plane, share);
  }

  /// `n_columns` numbers per key. A key is saved by one rank and may be restored by several; all
  /// that are asked for must be there.
  void rows(const std::string &name, const std::vector<std::int64_t> &keys,
            std::vector<double> &values, const std::size_t n_columns)
  {
    rows_of(prefix_ + name, keys, values, n_columns);
  }

private:
  virtual void common_bytes(const std::string &name, char *values, std::size_t n) = 0;
  /// That are kept, in bytes; when restoring.
  virtual std::size_t common_size(const std::string &name)                        = 0;
  virtual void planes_bytes(const std::string &name, char *values, std::size_t bytes_per_plane,
                            const PlaneShare &share)                              = 0;
  virtual void rows_of(const std::string &name, const std::vector<std::int64_t> &keys,
                       std::vector<double> &values, std::size_t n_columns)        = 0;

  template <class Values>
  void common_of_any_size(const std::string &name, Values &values)
  {
    using T = typename Values::value_type;
    static_assert(std::is_trivially_copyable_v<T>, "kept as bytes");
    if (is_restoring())
      values.resize(common_size(prefix_ + name) / sizeof(T));
    common(name, values.data(), values.size());
  }

  MPI_Comm communicator_;
  std::string prefix_;
};
} // namespace ricochet
