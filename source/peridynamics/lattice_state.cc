// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/lattice_state.h"

#include "plane_exchange.h"
#include "ricochet/peridynamics/plane_archive.h"

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

LatticeState::LatticeState(const Lattice &lattice, const bool cracks_push) :
  size_(lattice.size()), bonds_(lattice.intact_bonds()), cracked_(cracks_push ? bonds_.size() : 0)
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
  arrays.cracked      = cracks_push ? cracked_.data() : nullptr;
  arrays.free         = lattice.free_mask().data();
  arrays.half_weight = arrays.hold = nullptr;
  arrays.plastic                   = nullptr; // until BondFlow has some
  arrays.flowed                    = nullptr;
  arrays.strained                  = nullptr;
  if (lattice.zone() != nullptr)
  {
    arrays.half_weight = take();
    arrays.hold        = take();
    set_weights(lattice, 0, size_);
  }

  for (std::ptrdiff_t p = 0; p < size_; ++p)
  {
    const Vector3 position = lattice.reference_position(lattice.coordinates(p));
    for (int d = 0; d < 3; ++d)
      arrays.position[d][p] = position[d];
  }
}

void LatticeState::rest(const Lattice &lattice)
{
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        const Vector3 x = lattice.reference_position(lattice.coordinates(p));
        for (int d = 0; d < 3; ++d)
        {
          arrays.position[d][p] = x[d];
          arrays.velocity[d][p] = arrays.force[d][p] = 0.;
        }
      });
}

void LatticeState::set_weights(const Lattice &lattice, const std::ptrdiff_t first,
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
  set_weights(lattice, plane(first - edge), plane(last + edge));
}

void LatticeState::scale_weights(const Lattice &lattice, const std::vector<double> &factor)
{
  for (const auto &range : lattice.existing_ranges())
    for (std::ptrdiff_t p = range.first * Lattice::block_size; p < range.last * Lattice::block_size;
         ++p)
      if (lattice.exists(p))
        arrays.half_weight[p] *= factor[p];
}

void LatticeState::weigh(const Lattice &lattice, double *const field) const
{
  if (arrays.half_weight == nullptr)
    return;
  for (const auto &range : lattice.owned_ranges())
    for (std::ptrdiff_t p = range.first * Lattice::block_size; p < range.last * Lattice::block_size;
         ++p)
      field[p] *= 2. * arrays.half_weight[p];
}

void LatticeState::take_over(const LatticeState &before, const PlaneExchange &planes,
                             const Lattice &lattice)
{
  const auto &from = before.arrays;
  for (int d = 0; d < 3; ++d)
  {
    planes.move(from.position[d], arrays.position[d]);
    planes.move(from.velocity[d], arrays.velocity[d]);
  }
  planes.move(from.theta_before, arrays.theta_before);
  // A ghost's bonds with other ghosts do not exist here.
  const auto existing   = bonds_;
  const auto move_bonds = [&](const std::uint8_t *const old, std::uint8_t *const now)
  {
    planes.move(old, now,
                static_cast<double>(lattice.stencil().offsets.size()) / Lattice::block_size);
    for (std::size_t i = 0; i < existing.size(); ++i)
      now[i] &= existing[i];
  };
  move_bonds(from.bonds, arrays.bonds);
  if (from.cracked != nullptr)
    move_bonds(from.cracked, arrays.cracked);
}

void LatticeState::exchange_state(PlaneArchive &planes, const Lattice &lattice)
{
  static const char *const axis[] = {" x", " y", " z"};
  for (int d = 0; d < 3; ++d)
  {
    planes.field(std::string("position") + axis[d], arrays.position[d]);
    planes.field(std::string("velocity") + axis[d], arrays.velocity[d]);
  }
  planes.field("dilatation before", arrays.theta_before);
  const auto existing      = lattice.intact_bonds(); // as in take_over()
  const auto exchange_bits = [&](const std::string &name, std::vector<std::uint8_t> &bits)
  {
    planes.field(name, bits.data(),
                 static_cast<double>(lattice.stencil().offsets.size()) / Lattice::block_size);
    for (std::size_t i = 0; i < existing.size(); ++i)
      bits[i] &= existing[i];
  };
  exchange_bits("bonds", bonds_);
  if (arrays.cracked != nullptr)
    exchange_bits("closed cracks", cracked_);
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

void LatticeState::mirror_component(const Lattice &lattice, double *const field,
                                    const int component) const
{
  // 23 and 12 change their sign in the mirror.
  const double sign = component == 3 || component == 5 ? -1. : 1.;
  lattice.for_each_image([&](const std::ptrdiff_t image, const std::ptrdiff_t original)
                         { field[image] = sign * field[original]; });
}
} // namespace ricochet
