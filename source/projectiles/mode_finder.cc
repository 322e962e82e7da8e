// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mode_finder.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/output/checked_file.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace ricochet
{
namespace
{
/// Raise it when modes of the same mesh become others.
constexpr char version[] = "ricochet modes 1";

/// FNV-1a (Fowler, Noll, Vo), 64 bits, from two starts: 128 bits are no accident.
class Hash
{
public:
  void add(const void *data, const std::size_t n)
  {
    const auto *bytes = static_cast<const unsigned char *>(data);
    for (std::size_t i = 0; i < n; ++i)
      for (auto &state : states_)
        state = (state ^ bytes[i]) * 1099511628211ull;
  }
  template <class T>
  void add(const std::vector<T> &values)
  {
    const std::uint64_t n = values.size();
    add(&n, sizeof n);
    add(values.data(), n * sizeof(T));
  }
  std::string text() const
  {
    char buffer[33];
    std::snprintf(buffer, sizeof buffer, "%016llx%016llx",
                  static_cast<unsigned long long>(states_[0]),
                  static_cast<unsigned long long>(states_[1]));
    return buffer;
  }

private:
  std::uint64_t states_[2] = {14695981039346656037ull, 0x9e3779b97f4a7c15ull};
};

std::string hash_of(const std::string &bytes)
{
  Hash hash;
  hash.add(bytes.data(), bytes.size());
  return hash.text();
}

std::string as_bytes(const ProjectileModes &found)
{
  std::vector<double> numbers{static_cast<double>(found.modes.shape.size()),
                              static_cast<double>(found.modes.shape.front().size()),
                              found.compliance[0], found.compliance[1]};
  const auto add = [&](const std::vector<double> &values)
  { numbers.insert(numbers.end(), values.begin(), values.end()); };
  add(found.modes.squared_frequency);
  for (const auto &shape : found.modes.shape)
    add(shape);
  return {reinterpret_cast<const char *>(numbers.data()), numbers.size() * sizeof(double)};
}

ProjectileModes from_bytes(const std::string &bytes)
{
  std::vector<double> numbers(bytes.size() / sizeof(double));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  const auto n = static_cast<std::size_t>(numbers[0]), size = static_cast<std::size_t>(numbers[1]);
  auto next       = numbers.begin() + 4;
  const auto take = [&](const std::size_t count)
  {
    next += static_cast<std::ptrdiff_t>(count);
    return std::vector<double>(next - static_cast<std::ptrdiff_t>(count), next);
  };
  ProjectileModes found;
  found.compliance              = {numbers[2], numbers[3]};
  found.modes.squared_frequency = take(n);
  for (std::size_t k = 0; k < n; ++k)
    found.modes.shape.push_back(take(size));
  return found;
}

/// What the file holds behind version, key and the hash of it; empty if that is not what it holds.
std::string read_cached(const std::filesystem::path &path, const std::string &key)
{
  std::ifstream file(path, std::ios::binary);
  std::string head[3];
  for (auto &line : head)
    std::getline(file, line);
  if (!file || head[0] != version || head[1] != key)
    return "";
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  return hash_of(bytes) == head[2] ? bytes : "";
}

/// A cache that cannot be written is none.
void write_cached(const std::filesystem::path &path, const std::string &key,
                  const std::string &bytes)
{
  try
  {
    std::filesystem::create_directories(path.parent_path());
    // A name of its own: several runs may find the same modes at once.
    const std::filesystem::path own = path.string() + "." + std::to_string(getpid());
    write_file(own, std::string(version) + "\n" + key + "\n" + hash_of(bytes) + "\n" + bytes);
    std::filesystem::rename(own, path);
  }
  catch (const Error &)
  {
  }
  catch (const std::filesystem::filesystem_error &)
  {
  }
}
} // namespace

std::filesystem::path mode_cache()
{
  const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
  if (cache != nullptr && *cache != '\0')
    return std::filesystem::path(cache) / "ricochet";
  if (home != nullptr && *home != '\0')
    return std::filesystem::path(home) / ".cache" / "ricochet";
  return {};
}

std::string ModeFinder::key(const int n) const
{
  Hash hash;
  hash.add(version, sizeof version);
  hash.add(&n, sizeof n);
  const auto &solid      = mesh_.solid();
  const auto &material   = mesh_.material();
  const double numbers[] = {material.density, material.bulk_modulus, material.shear_modulus,
                            mesh_.multiplicity()};
  hash.add(numbers, sizeof numbers);
  for (const auto &node : solid.nodes)
    hash.add(node.data(), 3 * sizeof(double));
  hash.add(solid.cells);
  for (const auto &load : loads_)
    hash.add(load);
  return hash.text();
}

ProjectileModes ModeFinder::compute(const int n)
{
  if (vibration_ == nullptr)
    vibration_ = std::make_unique<FreeVibration>(mesh_);
  ProjectileModes found;
  found.modes = vibration_->lowest_modes(n);
  for (std::size_t i = 0; i < loads_.size(); ++i)
  {
    const auto u        = vibration_->static_displacement(loads_[i]);
    found.compliance[i] = 0.;
    for (std::size_t j = 0; j < u.size(); ++j)
      found.compliance[i] += mesh_.multiplicity() * loads_[i][j] * u[j];
  }
  return found;
}

/// A space and the bytes, or what went wrong.
std::string ModeFinder::on_this_rank(const int n)
{
  try
  {
    const auto folder = mode_cache();
    const auto name   = key(n);
    const auto path   = folder / ("modes-" + name + ".bin");
    std::string bytes = folder.empty() ? "" : read_cached(path, name);
    if (bytes.empty())
    {
      bytes = as_bytes(compute(n));
      if (!folder.empty())
        write_cached(path, name, bytes);
    }
    return " " + bytes;
  }
  catch (const Error &error)
  {
    return error.what();
  }
}

ProjectileModes ModeFinder::lowest(const int n)
{
  const bool first        = rank_in(communicator_) == 0;
  const std::string found = broadcast(communicator_, first ? on_this_rank(n) : "", 0);
  if (found.front() != ' ')
    throw InputError(found);
  return from_bytes(found.substr(1));
}
} // namespace ricochet
