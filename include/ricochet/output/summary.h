// SPDX-License-Identifier: LGPL-2.1-or-later
// The outcome of a run as one small JSON file for people, scripts and studies.
#pragma once

#include <filesystem>
#include <mpi.h>
#include <nlohmann/json_fwd.hpp>

namespace ricochet
{
/// Writes DIRECTORY/summary.json, replacing an older one; the content of rank 0 counts. Numbers
/// that are not finite become null. A field "checksum" is added, by which changes by hand are
/// found. Collective; throws FileError on all ranks.
void write_summary(MPI_Comm comm, const std::filesystem::path &directory,
                   const nlohmann::ordered_json &summary);

/// Whether a summary that has been read is as write_summary() wrote it: its field "checksum" says
/// so.
bool is_untouched(const nlohmann::ordered_json &summary);
} // namespace ricochet
