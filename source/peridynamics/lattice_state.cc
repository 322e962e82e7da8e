// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/lattice_state.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>
#include <utility>

namespace ricochet
{
namespace
{
constexpr int n_fields = 12, n_fields_of_zone = 2;
}

void LatticeState::Free::operator()(double *p) const
{
  std::free(p);
}

LatticeState::LatticeState(const Lattice &lattice) :
  size_(lattice.size()), bonds_(lattice.intact_bonds())
{
  const int n                 = n_fields + (lattice.zone() != nullptr ? n_fields_of_zone : 0);
  // Equal distances modulo 4096 bytes between the fields would make loads of one field wait for
  // stores to another (the processor compares the low 12 address bits first); 4096/12 rounded to
  // cache lines spreads them evenly.
  const std::ptrdiff_t stride = (size_ + 511) / 512 * 512 + 48;
  storage_.reset(static_cast<double *>(
      std::aligned_alloc(64, static_cast<std::size_t>(stride * n * 8 + 63) / 64 * 64)));
  if (!storage_)
    throw std::bad_alloc();
  std::fill(storage_.get(), storage_.get() + stride * n, 0.);
  double *next    = storage_.get();
  const auto take = [&] { return std::exchange(next, next + stride); };
  for (int d = 0; d < 3; ++d)
    arrays.position[d] = take();
  for (int d = 0; d < 3; ++d)
    arrays.velocity[d] = take();
  for (int d = 0; d < 3; ++d)
    arrays.force[d] = take();
  arrays.theta        = take();
  arrays.theta_before = take();
  arrays.energy       = take();
  arrays.bonds        = bonds_.data();
  arrays.free         = lattice.free_mask().data();
  arrays.half_weight = arrays.hold = nullptr;
  if (lattice.zone() != nullptr)
  {
    arrays.half_weight = take();
    arrays.hold        = take();
    weigh(lattice, 0, size_);
  }

  for (std::ptrdiff_t p = 0; p < size_; ++p)
  {
    const Vector3 position = lattice.reference_position(lattice.coordinates(p));
    for (int d = 0; d < 3; ++d)
      arrays.position[d][p] = position[d];
  }
}

void LatticeState::weigh(const Lattice &lattice, const std::ptrdiff_t first,
                         const std::ptrdiff_t last)
{
  for (std::ptrdiff_t p = first; p < last; ++p)
    if (lattice.exists(p))
    {
      arrays.half_weight[p] = 0.5 * lattice.weight(p);
      arrays.hold[p]        = lattice.kind(p) == PointKind::free ? 0. : 1.;
    }
}

void LatticeState::follow_zone(const Lattice &lattice, const int first, const int last)
{
  const std::ptrdiff_t reach = lattice.stencil().reach;
  const auto plane           = [&](const std::ptrdiff_t x)
  {
    return std::clamp<std::ptrdiff_t>((x - lattice.first_plane() + reach) * lattice.plane_stride(),
                                      0, lattice.owned_end() + reach * lattice.plane_stride());
  };
  // Weights depend on the layers of neighbouring cells.
  const int edge = lattice.zone()->points_per_edge();
  weigh(lattice, plane(first - edge), plane(last + edge));
}

void LatticeState::zero(const Lattice &lattice, double *field) const
{
  for (const auto &range : lattice.existing_ranges())
    std::fill(field + range.first * Lattice::block_size, field + range.last * Lattice::block_size,
              0.);
}

void LatticeState::mirror_motion(const Lattice &lattice)
{
  const double twice_plane = 2. * lattice.box().corner.y();
  lattice.for_each_image(
      [&](const std::ptrdiff_t image, const std::ptrdiff_t original)
      {
        arrays.position[0][image] = arrays.position[0][original];
        arrays.position[1][image] = twice_plane - arrays.position[1][original];
        arrays.position[2][image] = arrays.position[2][original];
        arrays.velocity[0][image] = arrays.velocity[0][original];
        arrays.velocity[1][image] = -arrays.velocity[1][original];
        arrays.velocity[2][image] = arrays.velocity[2][original];
      });
}

void LatticeState::mirror(const Lattice &lattice, double *const scalar) const
{
  lattice.for_each_image([&](const std::ptrdiff_t image, const std::ptrdiff_t original)
                         { scalar[image] = scalar[original]; });
}
} // namespace ricochet
