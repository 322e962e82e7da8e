// SPDX-License-Identifier: LGPL-2.1-or-later
// What writer and reader of a checkpoint have in common: rows of bytes of which each rank has some,
// and their checksums.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace ricochet
{
/// Some rows of all.
struct Rows
{
  std::size_t bytes_per_row;
  std::size_t first, n; // these
  std::size_t n_in_all;
};

/// Names of attributes.
constexpr const char *checksum_name = "checksum", *first_name = "first", *n_in_all_name = "of";

/// FNV-1a (Fowler, Noll, Vo), eight bytes at a time.
inline std::uint64_t checksum_of(const char *const bytes, const std::size_t n)
{
  constexpr std::uint64_t prime = 0x100000001b3;
  std::uint64_t sum             = 0xcbf29ce484222325;
  for (std::size_t i = 0; i < n; i += sizeof(std::uint64_t))
  {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + i, std::min(sizeof(word), n - i));
    sum = (sum ^ word) * prime;
    sum ^= sum >> 29; // else the upper bits of a word never reach the lower ones of the sum
  }
  return sum;
}
} // namespace ricochet
