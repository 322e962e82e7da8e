// SPDX-License-Identifier: LGPL-2.1-or-later
// The loop behind kernels/general_hex_kernel.h, written once on a SIMD type; see
// kernels/hex_kernel_loops.h for the rules.
#pragma once

#include "hex_modes.h"
#include "ricochet/kernels/general_hex_kernel.h"

namespace ricochet
{
namespace
{
template <bool with_energy>
void one_point(const HexArrays &arrays, const GeneralHexGroup &group)
{
  const V half_lambda = Simd::set(0.5 * group.lambda), mu = Simd::set(group.mu);
  const int64_t n = group.n_elements;
  for (int64_t first = 0; first < n; first += block_size)
    for (int lane = 0; lane < block_size && first + lane < n; lane += lanes)
    {
      const GeneralHexBlock &block = group.blocks[first / block_size];
      const int end                = first + lane + lanes < n ? lane + lanes : int(n - first);
      V mode[3][n_modes];
      gather_modes(arrays.position, block.entry, lane, mode);

      V F[3][3];
      for (int d = 0; d < 3; ++d)
      {
        V sum[3] = {Simd::zero(), Simd::zero(), Simd::zero()};
        for (int m = 0; m < n_modes; ++m)
        {
          const V b = Simd::load(block.gradient[m][d] + lane);
          for (int c = 0; c < 3; ++c)
            sum[c] = Simd::fma(mode[c][m], b, sum[c]);
        }
        for (int c = 0; c < 3; ++c)
          F[c][d] = sum[c];
      }
      const Symmetric twice_e = twice_green_strain(F);
      const V pressure        = half_lambda * (twice_e.a[0] + twice_e.a[1] + twice_e.a[2]);
      Symmetric S;
      for (int i = 0; i < 3; ++i)
      {
        S.a[i]     = Simd::fma(mu, twice_e.a[i], pressure);
        S.a[3 + i] = mu * twice_e.a[3 + i];
      }

      // f_a = -V P B_a - sum k q gamma_a = -(V P - sum k q X) B_a - sum k q Gamma_a
      const V volume  = Simd::load(block.volume + lane);
      const V bending = Simd::load(block.bending + lane),
              warping = Simd::load(block.warping + lane);
      V pull[3][3], hourglass[3][4]; // what multiplies B, and k q
      V twice = Simd::zero();
      for (int c = 0; c < 3; ++c)
      {
        V P[3];
        first_piola_kirchhoff(F[c], S, P);
        for (int d = 0; d < 3; ++d)
          pull[c][d] = volume * P[d];
        for (int alpha = 0; alpha < 4; ++alpha)
        {
          V q = mode[c][st + alpha];
          for (int d = 0; d < 3; ++d)
            q = Simd::fnma(F[c][d], Simd::load(block.reference[alpha][d] + lane), q);
          hourglass[c][alpha] = (alpha < 3 ? bending : warping) * q;
          for (int d = 0; d < 3; ++d)
            pull[c][d] = Simd::fnma(hourglass[c][alpha],
                                    Simd::load(block.reference[alpha][d] + lane), pull[c][d]);
          if constexpr (with_energy)
            twice = Simd::fma(hourglass[c][alpha], q, twice);
        }
      }
      V force[3][n_modes];
      for (int m = 0; m < n_modes; ++m)
      {
        const V b[3] = {Simd::load(block.gradient[m][0] + lane),
                        Simd::load(block.gradient[m][1] + lane),
                        Simd::load(block.gradient[m][2] + lane)};
        for (int c = 0; c < 3; ++c)
        {
          V f = m < st ? Simd::zero() : Simd::zero() - hourglass[c][m - st];
          for (int d = 0; d < 3; ++d)
            f = Simd::fnma(pull[c][d], b[d], f);
          force[c][m] = f;
        }
      }
      scatter(force, block.entry, lane, end, arrays.force);

      if constexpr (with_energy)
      {
        alignas(64) double energy[2][lanes];
        Simd::store(energy[0], Simd::set(0.25) * volume * four_energy_densities(S, twice_e));
        Simd::store(energy[1], Simd::set(0.5) * twice);
        for (int l = lane; l < end; ++l)
        {
          arrays.strain_energy[first + l]    = energy[0][l - lane];
          arrays.hourglass_energy[first + l] = energy[1][l - lane];
        }
      }
    }
}

const GeneralHexKernel kernel = {Simd::name, &one_point<false>, &one_point<true>};
} // namespace
} // namespace ricochet
