// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/search/pair_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
namespace
{
class BruteForce : public PairSearch
{
public:
  explicit BruteForce(const PairLoops &loops) : loops_(loops) {}

private:
  void search(const SearchPoints &all, const double radius, const SearchShare share,
              std::vector<PointPair> &pairs) const override
  {
    const auto &points = all.position;
    const auto &active = all.active;
    // Active points first: then only their rows are needed.
    std::vector<std::int32_t> number;
    const auto number_those = [&](const bool wanted)
    {
      for (std::size_t i = 0; i < points.size(); ++i)
        if ((active.empty() || active[i]) == wanted && points[i].allFinite())
          number.push_back(static_cast<std::int32_t>(i));
    };
    number_those(true);
    const auto n_rows = static_cast<std::int64_t>(number.size());
    number_those(false);
    const auto n_points = static_cast<std::int64_t>(number.size());
    number.resize(n_points + SortedPoints::padding);

    // Coordinates in units of the radius, and the error of a squared distance of about 1 in them.
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::max()), high = -low;
    for (std::int64_t i = 0; i < n_points; ++i)
    {
      low  = low.cwiseMin(points[number[i]]);
      high = high.cwiseMax(points[number[i]]);
    }
    const double e     = std::ldexp(n_points > 0 ? (high - low).maxCoeff() / radius : 0., -23);
    const double error = 8. * e + 16. * e * e + std::ldexp(1., -20);

    std::vector<float> u[3];
    for (int d = 0; d < 3; ++d)
    {
      u[d].resize(n_points + SortedPoints::padding);
      for (std::int64_t i = 0; i < n_points; ++i)
        u[d][i] = static_cast<float>((points[number[i]][d] - low[d]) / radius);
    }
    const std::vector<std::int32_t> image(n_points + SortedPoints::padding, 0);
    SortedPoints sorted{{u[0].data(), u[1].data(), u[2].data()},
                        image.data(),
                        nullptr,
                        number.data(),
                        points[0].data(),
                        radius * radius,
                        static_cast<float>(1. - error),
                        static_cast<float>(1. + error),
                        {},
                        0.f};
    const SortedFamilies families(all.families, number, n_points);
    families.add_to(sorted);
    const PairSink sink{[](void *target, const PointPair *found, const std::int64_t n)
                        {
                          auto &list = *static_cast<std::vector<PointPair> *>(target);
                          list.insert(list.end(), found, found + n);
                        },
                        &pairs};
    loops_.rows(sorted, n_rows, n_points, share.part, share.n_parts, sink);
  }

  const PairLoops &loops_;
};
} // namespace

std::unique_ptr<PairSearch> make_brute_force(const char *instruction_set)
{
  return std::make_unique<BruteForce>(pair_loops(instruction_set));
}
} // namespace ricochet
