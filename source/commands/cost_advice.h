// SPDX-License-Identifier: LGPL-2.1-or-later
// Accuracy against cost, in sentences: what is the cheapest that is good enough.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace ricochet
{
/// A scene that has been compared with the reference under some values of the axes.
struct ComparedScene
{
  std::string scene, group; // its name; the values of the axes, "" if there are none
  bool is_reference;
  nlohmann::ordered_json row; // as compare() returns it
};

/// Per group: the cheapest scene within 2 % and within 5 % of the reference's path and what it
/// costs, and which differences the scatter of the reference's own runs does not let one tell. A
/// line each.
std::string cost_advice(const std::vector<ComparedScene> &scenes);
} // namespace ricochet
