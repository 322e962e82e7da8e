// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench/search_points.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace ricochet
{
int lattice_size(const int n_points)
{
  return std::max(1, static_cast<int>(std::lround(std::cbrt(n_points))));
}

std::vector<Vector3> search_points(const std::string &arrangement, const int n_points,
                                   const double edge)
{
  std::vector<Vector3> points;
  if (arrangement == "lattice")
  {
    const int n          = lattice_size(n_points);
    const double spacing = edge / n;
    for (int x = 0; x < n; ++x)
      for (int y = 0; y < n; ++y)
        for (int z = 0; z < n; ++z)
          points.push_back(spacing * Vector3(x + 0.5, y + 0.5, z + 0.5));
    return points;
  }
  // Not std::uniform_real_distribution: the same points with every standard library.
  std::mt19937_64 engine(20240601);
  const auto uniform = [&] { return edge * std::ldexp(static_cast<double>(engine() >> 11), -53); };
  for (int i = 0; i < n_points; ++i)
  {
    const double x = uniform(), y = uniform(), z = uniform();
    points.emplace_back(x, y, z);
  }
  return points;
}

double expected_random_pairs(const double n_points, const double edge, const double radius)
{
  // The difference of two points uniform in the unit cube has the density (1 - |x|)(1 - |y|)(1 -
  // |z|); its integral over the ball of radius r <= 1, where |x|, |x y| and |x y z| integrate to
  // pi r^4/2, 8 r^5/15 and r^6/6, is the share of pairs closer than r.
  const double r           = radius / edge;
  const double probability = 4. / 3. * M_PI * std::pow(r, 3) - 3. / 2. * M_PI * std::pow(r, 4) +
                             8. / 5. * std::pow(r, 5) - std::pow(r, 6) / 6.;
  return 0.5 * n_points * (n_points - 1.) * probability;
}

double lattice_pairs(const int n, const double spacing, const double radius)
{
  // Every offset, here those with positive coordinates, fits (n - |x|)(n - |y|)(n - |z|) times.
  const int reach = std::min(n - 1, static_cast<int>(radius / spacing) + 1);
  double directed = 0.;
  for (int x = 0; x <= reach; ++x)
    for (int y = 0; y <= reach; ++y)
      for (int z = 0; z <= reach; ++z)
        if (x + y + z > 0 && spacing * std::sqrt(x * x + y * y + z * z) < radius)
          directed += (x ? 2. : 1.) * (y ? 2. : 1.) * (z ? 2. : 1.) * (n - x) * (n - y) * (n - z);
  return 0.5 * directed;
}

double expected_pairs(const std::string &arrangement, const int n_points, const double edge,
                      const double radius)
{
  const int n = lattice_size(n_points);
  return arrangement == "lattice" ? lattice_pairs(n, edge / n, radius)
                                  : expected_random_pairs(n_points, edge, radius);
}
} // namespace ricochet
