// SPDX-License-Identifier: LGPL-2.1-or-later
#include "history_rows.h"

#include "reference_data.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/scene/text_tools.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace ricochet
{
HistoryRows read_history_rows(const std::filesystem::path &path)
{
  std::ifstream in(path);
  std::string line;
  if (!std::getline(in, line))
    throw FileError("The history " + path.string() + " cannot be read.");
  std::vector<std::string> names;
  for (const auto &head : split(line, ','))
    names.push_back(head.substr(0, head.find(" [")));
  HistoryRows rows;
  while (std::getline(in, line))
    if (const auto cells = split(line, ','); cells.size() == names.size())
      for (std::size_t i = 0; i < cells.size(); ++i)
        rows[names[i]].push_back(std::strtod(cells[i].c_str(), nullptr));
  auto &path_length = rows[path_column];
  const auto &x = rows["x"], &y = rows["y"], &z = rows["z"];
  for (std::size_t i = 0; i < x.size(); ++i)
    path_length.push_back(i == 0 ? 0.
                                 : path_length[i - 1] + std::hypot(x[i] - x[i - 1], y[i] - y[i - 1],
                                                                   z[i] - z[i - 1]));
  return rows;
}

std::optional<double> interpolated(const std::vector<double> &times,
                                   const std::vector<double> &values, const double time)
{
  if (times.empty() || values.size() != times.size() || time < times.front() || time > times.back())
    return {};
  const auto next = std::lower_bound(times.begin(), times.end(), time) - times.begin();
  if (next == 0 || times[next] == time)
    return values[next];
  const double share = (time - times[next - 1]) / (times[next] - times[next - 1]);
  return values[next - 1] + share * (values[next] - values[next - 1]);
}
} // namespace ricochet
