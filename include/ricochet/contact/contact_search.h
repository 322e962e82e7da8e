// SPDX-License-Identifier: LGPL-2.1-or-later
// The methods that find points which may touch.
#pragma once

#include <string>
#include <vector>

namespace ricochet
{
/// Names of the methods: those of search/pair_search.h, used by each rank on its own points and
/// what comes near them, and "hybrid", see search/hybrid_search.h. The fastest first
/// (doc/contact_search.md).
std::vector<std::string> contact_search_names();
} // namespace ricochet
