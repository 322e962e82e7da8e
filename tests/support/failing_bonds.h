// SPDX-License-Identifier: LGPL-2.1-or-later
// Arrays and tables as the lattice kernels see them, of a shaken block whose bonds are intact,
// cracked or gone, some of them with a plastic part: to hold the kernels against plain loops.
#pragma once

#include "ricochet/peridynamics/bond_history.h"
#include "ricochet/peridynamics/bond_tables.h"
#include "ricochet/peridynamics/lattice_state.h"
#include "support/body.h"

#include <cmath>
#include <vector>

namespace ricochet::tests
{
struct FailingBonds
{
  static constexpr double spacing = 1e-3, critical_stretch = 0.04;

  /// All bonds intact, nothing flowed, at rest; no row is a multiple of 8 long.
  explicit FailingBonds(const BondLawSample &sample, const bool cracks_push = true) :
    law(bond_law(sample.law)), material{&law,
                                        sample.density,
                                        sample.bulk_modulus,
                                        sample.shear_modulus,
                                        critical_stretch,
                                        {},
                                        HistoryPrecision::single_precision,
                                        cracks_push,
                                        {20e6, 0.07, 0.2}},
    lattice({Vector3::Zero(), spacing, {7, 6, 5}, false},
            make_stencil(spacing, 3., InfluenceFunction::cone), 0, 1),
    state(lattice, cracks_push), tables(lattice, material), table(tables.breakable()),
    last_block(lattice.owned_end() / Lattice::block_size), half_weight(lattice.size(), 0.),
    hold(lattice.size(), 0.), strained(lattice.size(), 0.),
    flowed(lattice.size() / Lattice::block_size, 0),
    plastic(lattice.size(), table.n, 1, HistoryPrecision::single_precision)
  {
  }

  std::size_t byte(const std::ptrdiff_t p, const int k) const
  {
    return p / Lattice::block_size * table.n + k;
  }
  bool is_set(const std::uint8_t *const bonds, const std::ptrdiff_t p, const int k) const
  {
    return bonds != nullptr && (bonds[byte(p, k)] >> (p % Lattice::block_size)) & 1;
  }
  bool intact(const std::ptrdiff_t p, const int k) const
  {
    return is_set(state.arrays.bonds, p, k);
  }
  bool cracked(const std::ptrdiff_t p, const int k) const
  {
    return is_set(state.arrays.cracked, p, k);
  }

  /// visit(p, q, k) for all bonds that are intact or cracked.
  template <class Visitor>
  void for_each_bond(Visitor &&visit) const
  {
    for (std::ptrdiff_t p = 0; p < last_block * Lattice::block_size; ++p)
      for (int k = 0; k < table.n; ++k)
        if (intact(p, k) || cracked(p, k))
          visit(p, p + static_cast<std::ptrdiff_t>(table.shift[k]), k);
  }

  /// y of a bond [m].
  Vector3 apart(const std::ptrdiff_t p, const std::ptrdiff_t q) const
  {
    return at(state.arrays.position, q) - at(state.arrays.position, p);
  }
  /// All of it [m].
  double extension(const std::ptrdiff_t p, const std::ptrdiff_t q, const int k) const
  {
    return apart(p, q).norm() - table.constants[k].length;
  }
  /// Less its plastic part [m].
  double elastic_extension(const std::ptrdiff_t p, const std::ptrdiff_t q, const int k) const
  {
    return extension(p, q, k) - plastic.read(p, k, 0);
  }

  /// Moves points away from their places by up to `amplitude` spacings along each axis.
  void shake(Random &random, const double amplitude)
  {
    lattice.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          set(state.arrays.position, p,
              lattice.reference_position(lattice.coordinates(p)) +
                  amplitude * spacing * random.vector());
          set(state.arrays.velocity, p, 10. * random.vector());
          state.arrays.theta[p] = 0.01 * random.uniform();
        });
  }
  /// A third of the bonds stay intact, a third crack, a third is gone.
  void crack(Random &random)
  {
    for_each_bond(
        [&](const std::ptrdiff_t p, std::ptrdiff_t, const int k)
        {
          const double lot       = random.uniform();
          const std::uint8_t bit = std::uint8_t(1u << (p % Lattice::block_size));
          if (lot > 1. / 3.)
            return;
          state.arrays.bonds[byte(p, k)] &= std::uint8_t(~bit);
          if (lot > -1. / 3.)
            state.arrays.cracked[byte(p, k)] |= bit;
        });
  }
  /// Two blocks out of three have plastic extensions of up to 0.02 spacings.
  void flow(Random &random)
  {
    state.arrays.plastic  = plastic.singles();
    state.arrays.flowed   = flowed.data();
    state.arrays.strained = strained.data();
    for (std::size_t block = 0; block < flowed.size(); ++block)
      flowed[block] = block % 3 != 0;
    for_each_bond(
        [&](const std::ptrdiff_t p, std::ptrdiff_t, const int k)
        {
          if (flowed[p / Lattice::block_size])
            plastic.write(p, k, 0, 0.02 * spacing * random.uniform());
        });
  }
  /// Points have weights, and some are held.
  void weigh(Random &random)
  {
    state.arrays.half_weight = half_weight.data();
    state.arrays.hold        = hold.data();
    lattice.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          half_weight[p] = 0.3 + 0.2 * random.uniform();
          hold[p]        = random.uniform() > 0.5 ? 1. : 0.;
        });
  }

  BondLaw law;
  PeridynamicMaterial material;
  Lattice lattice;
  LatticeState state;
  BondTables tables;
  BondTable table;
  std::int64_t last_block;
  std::vector<double> half_weight, hold, strained;
  std::vector<std::uint8_t> flowed;
  BondHistory plastic;
};

/// Kernels of a law that this processor has.
inline std::vector<const LatticeKernel *> kernels_of(const BondLaw &law)
{
  std::vector<const LatticeKernel *> kernels;
  for (const char *set_name : {"baseline", "avx2", "avx512"})
    if (const auto *const kernel = lattice_kernel(law.index, set_name))
      kernels.push_back(kernel);
  return kernels;
}
} // namespace ricochet::tests
