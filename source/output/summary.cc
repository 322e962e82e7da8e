// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/summary.h"

#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstdio>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

/// A title typed in another encoding must not cost the user the summary of a long run: what is not
/// UTF-8 is replaced.
std::string text_of(const Json &summary, const int indent)
{
  return summary.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// FNV-1a (http://www.isthe.com/chongo/tech/comp/fnv/) of the text, 64 bits in hexadecimal.
std::string checksum(const Json &summary)
{
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text_of(summary, -1))
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}
} // namespace

bool is_untouched(const Json &summary)
{
  if (!summary.is_object() || !summary.contains("checksum"))
    return false;
  auto bare = summary;
  bare.erase("checksum");
  // As text, since numbers that are not finite have become null.
  return summary["checksum"] == checksum(bare);
}

void write_summary(const MPI_Comm comm, const std::filesystem::path &directory,
                   const nlohmann::ordered_json &summary)
{
  on_first_rank(comm,
                [&]
                {
                  auto written        = summary;
                  written["checksum"] = checksum(summary);
                  write_file(directory / "summary.json", text_of(written, 2) + "\n");
                });
}
} // namespace ricochet
