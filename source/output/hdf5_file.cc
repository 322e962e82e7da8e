// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hdf5_file.h"

#include "hdf5_handle.h"
#include "ricochet/base/version.h"
#include "ricochet/output/checked_file.h"

#include <algorithm>
#include <cassert>

namespace ricochet
{
namespace
{
hid_t type_of(const double *)
{
  return H5T_NATIVE_DOUBLE;
}
hid_t type_of(const float *)
{
  return H5T_NATIVE_FLOAT;
}
hid_t type_of(const int *)
{
  return H5T_NATIVE_INT;
}

hid_t create_in_memory()
{
  const SilencedReport silenced;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "create an access list");
  check(H5Pset_fapl_core(access, /*increment=*/1 << 16, /*backing_store=*/false),
        "select its memory driver");
  static int n_files     = 0; // HDF5 refuses to open two files of one name, in memory as well
  const std::string name = "in memory " + std::to_string(++n_files);
  return H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
}

void add_text(const hid_t owner, const std::string &name, const std::string &text)
{
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "create a text type");
  check(H5Tset_size(type, std::max<std::size_t>(text.size(), 1)), "set the length of " + name);
  check(H5Tset_cset(type, H5T_CSET_UTF8), "set the character set of " + name);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create a scalar");
  const Handle attribute(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, "create the attribute " + name);
  check(H5Awrite(attribute, type, text.c_str()), "write the attribute " + name);
}

template <typename Number>
void add_dataset(const hid_t file, const std::string &name, const std::vector<Number> &values,
                 const std::size_t n_columns, const std::string &unit)
{
  const SilencedReport silenced;
  assert(n_columns > 0 && values.size() % n_columns == 0);
  const hsize_t n_rows  = values.size() / n_columns;
  const hsize_t size[2] = {n_rows, n_columns};
  const int rank        = n_columns > 1 ? 2 : 1;

  const Handle space(H5Screate_simple(rank, size, nullptr), H5Sclose,
                     "create the shape of " + name);
  const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "create the layout of " + name);
  if (n_rows > 1000)
  {
    const hsize_t chunk[2] = {std::min<hsize_t>(n_rows, 1 << 16), n_columns};
    check(H5Pset_chunk(layout, rank, chunk), "cut " + name + " into chunks");
    check(H5Pset_shuffle(layout), "shuffle " + name);
    check(H5Pset_deflate(layout, 2), "compress " + name);
  }
  const hid_t type = type_of(values.data());
  const Handle dataset(
      H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, layout, H5P_DEFAULT), H5Dclose,
      "create the dataset " + name);
  if (n_rows > 0)
    check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          "write the dataset " + name);
  add_text(dataset, "unit", unit);
}
} // namespace

struct Hdf5File::Handles
{
  Handle file{create_in_memory(), H5Fclose, "create a file in memory"};
};

Hdf5File::Hdf5File() : handles_(std::make_unique<Handles>())
{
  add_text(handles_->file, "ricochet_version", version());
}

Hdf5File::~Hdf5File() = default;

void Hdf5File::set_attribute(const std::string &name, const double value)
{
  const SilencedReport silenced;
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create a scalar");
  const Handle attribute(
      H5Acreate2(handles_->file, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, "create the attribute " + name);
  check(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value), "write the attribute " + name);
}

void Hdf5File::add(const std::string &name, const std::vector<double> &values,
                   const std::size_t n_columns, const std::string &unit)
{
  add_dataset(handles_->file, name, values, n_columns, unit);
}

void Hdf5File::add(const std::string &name, const std::vector<float> &values,
                   const std::size_t n_columns, const std::string &unit)
{
  add_dataset(handles_->file, name, values, n_columns, unit);
}

void Hdf5File::add(const std::string &name, const std::vector<int> &values,
                   const std::size_t n_columns, const std::string &unit)
{
  add_dataset(handles_->file, name, values, n_columns, unit);
}

void Hdf5File::add(const std::string &name, const char *const values, const Rows &rows)
{
  const SilencedReport silenced;
  const hsize_t size[2] = {rows.n, rows.bytes_per_row};
  const Handle space(H5Screate_simple(2, size, nullptr), H5Sclose, "create the shape of " + name);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "create a list of links");
  check(H5Pset_create_intermediate_group(links, 1), "ask for groups");
  const Handle dataset(H5Dcreate2(handles_->file, name.c_str(), H5T_NATIVE_UINT8, space, links,
                                  H5P_DEFAULT, H5P_DEFAULT),
                       H5Dclose, "create the dataset " + name);
  const std::pair<const char *, std::uint64_t> attributes[] = {
      {checksum_name, checksum_of(values, rows.n * rows.bytes_per_row)},
      {first_name, rows.first},
      {n_in_all_name, rows.n_in_all}};
  for (const auto &[key, value] : attributes)
  {
    const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, "create a scalar");
    const Handle attribute(
        H5Acreate2(dataset, key, H5T_NATIVE_UINT64, scalar, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
        std::string("create the attribute ") + key);
    check(H5Awrite(attribute, H5T_NATIVE_UINT64, &value), std::string("write ") + key);
  }
  if (rows.n > 0 && rows.bytes_per_row > 0)
    check(H5Dwrite(dataset, H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
          "write the dataset " + name);
}

void Hdf5File::link(const std::string &name, const std::string &file)
{
  const SilencedReport silenced;
  check(
      H5Lcreate_external(file.c_str(), "/", handles_->file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
      "create the link " + name);
}

void Hdf5File::save(const std::filesystem::path &path, const Durability durability)
{
  const SilencedReport silenced;
  check(H5Fflush(handles_->file, H5F_SCOPE_GLOBAL), "complete " + path.string());
  const ssize_t size = H5Fget_file_image(handles_->file, nullptr, 0);
  check(size < 0 ? -1 : 0, "measure " + path.string());
  std::string bytes(static_cast<std::size_t>(size), '\0');
  check(H5Fget_file_image(handles_->file, bytes.data(), bytes.size()) < 0 ? -1 : 0,
        "copy " + path.string());
  write_file(path, bytes, durability);
}
} // namespace ricochet
