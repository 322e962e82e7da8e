// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections and their entries as JSON, see scene/parameter_template.h.
#pragma once

#include "section.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace ricochet
{
nlohmann::ordered_json describe_section(const Section &section, const std::string &file);

nlohmann::ordered_json describe_entry(const Section &section, const Entry &entry,
                                      const std::string &file);
} // namespace ricochet
