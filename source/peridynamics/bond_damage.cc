// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/bond_damage.h"

#include "plane_exchange.h"
#include "ricochet/peridynamics/plane_archive.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet
{
namespace
{
/// Each bond has two ends.
double half_of_all(double ends, const MPI_Comm communicator)
{
  MPI_Allreduce(MPI_IN_PLACE, &ends, 1, MPI_DOUBLE, MPI_SUM, communicator);
  return ends / 2.;
}
} // namespace

BondDamage::BondDamage(const Lattice &lattice, const LatticeState &state,
                       const LatticeKernel &kernel) :
  lattice_(lattice),
  state_(state), shifts_(lattice.shifts()), log_(shifts_)
{
  const std::size_t n_blocks = lattice.size() / Lattice::block_size;
  sound_.assign(state.arrays.bonds, state.arrays.bonds + n_blocks * shifts_.size());
  open_.assign(lattice.size(), 0);
  log_.make_room(kernel, n_blocks);
  count_families(lattice);
  if (lattice.has_cutouts())
    find_rims();
}

/// Contact reaches no further than the next point: walls that come nearer have one of these.
void BondDamage::find_rims()
{
  for (const auto &range : lattice_.existing_ranges())
    for (std::ptrdiff_t p = range.first * Lattice::block_size; p < range.last * Lattice::block_size;
         ++p)
    {
      if (!lattice_.exists(p))
        continue;
      const auto c = lattice_.coordinates(p);
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = -1; z <= 1; ++z)
            if (lattice_.is_cut_out({c[0] + x, c[1] + y, c[2] + z}))
              open_[p] |= at_rim;
    }
}

/// Whether the body lacks a place that a bond passes: the nearest ones to it, at half spacings.
bool BondDamage::spans_cutout(const std::array<int, 3> &from, const Stencil::Offset &o) const
{
  const int n   = 2 * lattice_.stencil().reach;
  const auto at = [n](const int start, const int length, const int i)
  { return start + static_cast<int>(std::lround(static_cast<double>(length * i) / n)); };
  for (int i = 1; i < n && lattice_.has_cutouts(); ++i)
    if (lattice_.is_cut_out({at(from[0], o.x, i), at(from[1], o.y, i), at(from[2], o.z, i)}))
      return true;
  return false;
}

double BondDamage::sever(LatticeState &state,
                         const std::function<bool(const Vector3 &, const Vector3 &)> &crosses)
{
  double n_ends            = 0.;
  const auto &offsets      = lattice_.stencil().offsets;
  std::uint8_t *const bond = state.arrays.bonds, *const cracked = state.arrays.cracked;
  for (std::ptrdiff_t p = 0; p < lattice_.owned_end(); ++p)
  {
    if (!lattice_.exists(p))
      continue;
    const auto c            = lattice_.coordinates(p);
    const Vector3 X         = lattice_.reference_position(c);
    const std::size_t first = p / Lattice::block_size * offsets.size();
    const std::uint8_t lane = std::uint8_t(1u << (p % Lattice::block_size));
    for (std::size_t k = 0; k < offsets.size(); ++k)
    {
      const auto &o = offsets[k];
      if ((bond[first + k] & lane) == 0 ||
          !crosses(X, lattice_.reference_position({c[0] + o.x, c[1] + o.y, c[2] + o.z})))
        continue;
      bond[first + k] &= static_cast<std::uint8_t>(~lane);
      if (cracked != nullptr && !spans_cutout(c, o)) // whose walls are apart
        cracked[first + k] |= lane;
      for (const std::ptrdiff_t end : {p, p + lattice_.shift(o)})
      {
        open_[end] |= damaged;
        n_ends += lattice_.owned(end) ? 1. : 0.;
      }
    }
  }
  return n_ends;
}

void BondDamage::mark_damaged()
{
  log_.for_each(
      [&](const std::ptrdiff_t p, const std::ptrdiff_t q, std::size_t)

      {
        open_[p] |= damaged;
        open_[q] |= damaged;
      });
}

std::vector<std::uint8_t> BondDamage::follow_zone(const int first, const int last,
                                                  LatticeState &state)
{
  // Bonds of the planes below reach up into the changed ones.
  const std::ptrdiff_t reach = lattice_.stencil().reach;
  const auto block_of        = [&](const std::ptrdiff_t plane)
  {
    return std::clamp<std::ptrdiff_t>((plane - lattice_.first_plane() + reach) *
                                          lattice_.plane_stride(),
                                      0, lattice_.owned_end()) /
           Lattice::block_size;
  };
  const std::int64_t from = block_of(first - reach), to = block_of(last);
  const std::size_t begin = from * shifts_.size(), end = to * shifts_.size();
  std::vector<std::uint8_t> appeared(sound_.size(), 0);
  std::copy(sound_.begin() + begin, sound_.begin() + end, appeared.begin() + begin);
  lattice_.set_intact_bonds(from, to, sound_.data());
  for (std::size_t i = begin; i < end; ++i)
  {
    appeared[i] = sound_[i] & ~appeared[i];
    state.arrays.bonds[i] |= appeared[i];
  }
  count_families(lattice_);
  return appeared;
}

void BondDamage::redistribute(const PlaneExchange &planes, const Lattice &share,
                              std::vector<std::uint8_t> sound, const LatticeKernel &kernel)
{
  planes.move(open_);
  sound_ = std::move(sound);
  log_.make_room(kernel, share.size() / Lattice::block_size);
  log_.clear();
  count_families(share);
}

void BondDamage::count_families(const Lattice &lattice)
{
  sound_family_.assign(lattice.size(), 0);
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      { sound_family_[p] = static_cast<std::uint16_t>(family_size(p, sound_.data())); });
}

int BondDamage::family_size(const std::ptrdiff_t index, const std::uint8_t *bonds) const
{
  const auto bond = [&](const std::ptrdiff_t p, const std::size_t k)
  {
    return (bonds[(p / Lattice::block_size) * shifts_.size() + k] >> (p % Lattice::block_size)) & 1;
  };
  int n = 0;
  for (std::size_t k = 0; k < shifts_.size(); ++k)
    n += bond(index, k) + (index >= shifts_[k] ? bond(index - shifts_[k], k) : 0);
  return n;
}

double BondDamage::damage(const std::ptrdiff_t index) const
{
  if (sound_family_[index] == 0 || !is_damaged(index))
    return 0.;
  return 1. - double(family_size(index, state_.arrays.bonds)) / sound_family_[index];
}

double BondDamage::count_intact(const MPI_Comm communicator) const
{
  double ends = 0.;
  lattice_.for_each_owned([&](const std::ptrdiff_t p)
                          { ends += family_size(p, state_.arrays.bonds); });
  return half_of_all(ends, communicator);
}

double BondDamage::count_sound(const MPI_Comm communicator) const
{
  double ends = 0.;
  lattice_.for_each_owned([&](const std::ptrdiff_t p) { ends += sound_family_[p]; });
  return half_of_all(ends, communicator);
}

void BondDamage::exchange_state(PlaneArchive &planes)
{
  planes.field("open", open_.data());
}
} // namespace ricochet
