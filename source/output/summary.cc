// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/summary.h"

#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"

#include <nlohmann/json.hpp>

namespace ricochet
{
void write_summary(const MPI_Comm comm, const std::filesystem::path &directory,
                   const nlohmann::ordered_json &summary)
{
  on_first_rank(comm,
                [&]
                {
                  // A title typed in another encoding must not cost the user the summary of a long
                  // run: replace what is not UTF-8.
                  using Json = nlohmann::ordered_json;
                  write_file(directory / "summary.json",
                             summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
                });
}
} // namespace ricochet
