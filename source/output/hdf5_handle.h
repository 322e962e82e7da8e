// SPDX-License-Identifier: LGPL-2.1-or-later
// HDF5's identifiers and failures as those of C++.
#pragma once

#include "ricochet/base/exceptions.h"

#include <hdf5.h>
#include <utility>

namespace ricochet
{
/// Throws FileError if HDF5 has failed in what it was asked to do.
inline void check(const herr_t result, const std::string &what)
{
  if (result < 0)
    throw FileError("HDF5 cannot " + what +
                    ". Check the free memory; otherwise the HDF5 library is faulty.");
}

/// While it lives HDF5 does not print its own report of a failure: failures become exceptions here,
/// and the report would only repeat them. Whoever else uses HDF5 in this process finds it as
/// before.
class SilencedReport
{
public:
  SilencedReport()
  {
    H5Eget_auto2(H5E_DEFAULT, &report_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~SilencedReport() { H5Eset_auto2(H5E_DEFAULT, report_, data_); }
  SilencedReport(const SilencedReport &)            = delete;
  SilencedReport &operator=(const SilencedReport &) = delete;

private:
  H5E_auto2_t report_ = nullptr;
  void *data_         = nullptr;
};

/// An HDF5 identifier and the function that gives it back.
class Handle
{
public:
  Handle(const hid_t id, herr_t (*close)(hid_t), const std::string &what) : id_(id), close_(close)
  {
    check(id < 0 ? -1 : 0, what);
  }
  ~Handle()
  {
    if (id_ >= 0)
      close_(id_);
  }
  Handle(Handle &&other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle &)            = delete;
  Handle &operator=(const Handle &) = delete;
  operator hid_t() const { return id_; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};
} // namespace ricochet
