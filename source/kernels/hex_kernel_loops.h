// SPDX-License-Identifier: LGPL-2.1-or-later
// The loops behind kernels/hex_kernel.h, written once on a SIMD type. Each including file defines,
// in an unnamed namespace before this header, a struct Simd of its instruction set, so that nothing
// compiled here is visible outside that file.
#pragma once

#include "hex_modes.h"
#include "ricochet/kernels/hex_kernel.h"

namespace ricochet
{
namespace
{
struct Element
{
  V mode[3][n_modes]; // of the position [m]
  V edge;             // [m]
};

inline Element load(const double *position, const HexBlock &block, const int lane)
{
  Element e;
  e.edge = Simd::load(block.edge + lane);
  gather_modes(position, block.entry, lane, e.mode);
  return e;
}

struct SharedModuli
{
  static constexpr bool relaxes = false;
  V half_lambda, tetragonal, diagonal;

  SharedModuli(const HexGroup &group, int64_t, int, const HexRelaxation *) :
    half_lambda(Simd::set(0.5 * group.lambda)), tetragonal(Simd::set(group.mu_tetragonal)),
    diagonal(Simd::set(group.mu_diagonal))
  {
  }

  Symmetric stress(int, const Symmetric &twice_e) const
  {
    const V pressure = half_lambda * (twice_e.a[0] + twice_e.a[1] + twice_e.a[2]);
    Symmetric S;
    for (int i = 0; i < 3; ++i)
    {
      S.a[i]     = Simd::fma(tetragonal, twice_e.a[i], pressure);
      S.a[3 + i] = diagonal * twice_e.a[3 + i];
    }
    return S;
  }

  /// What relaxes: 2 mu times the deviator.
  Symmetric shear_stress(int, const Symmetric &twice_e) const
  {
    const V mean = Simd::set(1. / 3.) * (twice_e.a[0] + twice_e.a[1] + twice_e.a[2]);
    Symmetric S;
    for (int i = 0; i < 3; ++i)
    {
      S.a[i]     = tetragonal * (twice_e.a[i] - mean);
      S.a[3 + i] = diagonal * twice_e.a[3 + i];
    }
    return S;
  }

  static V four_energies(const Symmetric &S, const Symmetric &twice_e)
  {
    return four_energy_densities(S, twice_e);
  }
};

struct OwnTensors
{
  static constexpr bool relaxes = false;
  const HexTensors *tensors, *shear;
  int lane;

  OwnTensors(const HexGroup &group, const int64_t block, const int lane,
             const HexRelaxation *relaxation) :
    tensors(group.tensors + block),
    shear(relaxation == nullptr ? nullptr : relaxation->shear + block), lane(lane)
  {
  }

  Symmetric stress(const int point, const Symmetric &twice_e) const
  {
    return product(tensors->c[point], twice_e);
  }
  Symmetric shear_stress(const int point, const Symmetric &twice_e) const
  {
    return product(shear->c[point], twice_e);
  }
  static V four_energies(const Symmetric &S, const Symmetric &twice_e)
  {
    return four_energy_densities(S, twice_e);
  }

private:
  Symmetric product(const double (&c)[HexTensors::n_entries][block_size],
                    const Symmetric &twice_e) const
  {
    Symmetric e, S;
    for (int i = 0; i < 3; ++i)
    {
      e.a[i]     = Simd::set(0.5) * twice_e.a[i];
      e.a[3 + i] = twice_e.a[3 + i];
      S.a[i] = S.a[3 + i] = Simd::zero();
    }
    int k = 0;
    for (int i = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j, ++k)
      {
        const V value = Simd::load(c[k] + lane);
        S.a[i]        = Simd::fma(value, e.a[j], S.a[i]);
        if (j > i)
          S.a[j] = Simd::fma(value, e.a[i], S.a[j]);
      }
    return S;
  }
};

/// Another law whose shear part relaxes. stress() must be called once per point and step.
template <class Law, bool with_energy>
struct Relaxing : Law
{
  static constexpr bool relaxes = true;
  const HexRelaxation &relaxation;
  double *history; // of this block's first point
  int lane;
  V equilibrium;                       // share of the shear stiffness that does not relax
  V four_losses        = Simd::zero(); // 4 times the dissipated densities, summed over points
  V four_energies_here = Simd::zero(); // of the last point

  Relaxing(const HexGroup &group, const int64_t block, const int lane,
           const HexRelaxation *relaxation, const int n_points) :
    Law(group, block, lane, relaxation),
    relaxation(*relaxation), history(relaxation->history + block * n_points * rows() * block_size),
    lane(lane)
  {
    double share = 1.;
    for (int k = 0; k < relaxation->n_branches; ++k)
      share -= relaxation->branches[k].share;
    equilibrium = Simd::set(share);
  }

  int rows() const { return 6 * (1 + relaxation.n_branches); }

  Symmetric stress(const int point, const Symmetric &twice_e)
  {
    double *row = history + point * rows() * block_size + lane;
    Symmetric change, back; // of 2 E; 2 sum lambda_k E_b,k
    for (int i = 0; i < 6; ++i)
    {
      change.a[i] = twice_e.a[i] - Simd::load(row + i * block_size);
      back.a[i]   = Simd::zero();
      Simd::store(row + i * block_size, twice_e.a[i]);
    }
    const Symmetric elastic = Law::stress(point, twice_e);
    // Stored: what does not relax, and the branches' springs.
    if constexpr (with_energy)
      four_energies_here = four_energy_densities(elastic, twice_e) -
                           (Simd::set(1.) - equilibrium) *
                               four_energy_densities(Law::shear_stress(point, twice_e), twice_e);
    for (int k = 0; k < relaxation.n_branches; ++k)
    {
      const MaxwellStep &branch = relaxation.branches[k];
      const V share = Simd::set(branch.share), decay = Simd::set(branch.decay),
              at_once = Simd::set(1. - branch.lag);
      row += 6 * block_size;
      Symmetric held, sum, moved;
      for (int i = 0; i < 6; ++i)
      {
        // What a branch holds back, d = E - E_b: d(n+1) = r d(n) + (1 - beta) (E(n+1) - E(n)).
        const V before = Simd::load(row + i * block_size);
        held.a[i]      = Simd::fma(decay, before, at_once * change.a[i]);
        sum.a[i]       = held.a[i] + before;
        moved.a[i]     = change.a[i] - (held.a[i] - before);
        back.a[i]      = Simd::fma(share, twice_e.a[i] - held.a[i], back.a[i]);
        Simd::store(row + i * block_size, held.a[i]);
      }
      four_losses = Simd::fma(share, four_energy_densities(Law::shear_stress(point, sum), moved),
                              four_losses);
      if constexpr (with_energy)
        four_energies_here = Simd::fma(
            share, four_energy_densities(Law::shear_stress(point, held), held), four_energies_here);
    }
    const Symmetric relaxed = Law::shear_stress(point, back);
    Symmetric S;
    for (int i = 0; i < 6; ++i)
      S.a[i] = elastic.a[i] - relaxed.a[i];
    return S;
  }

  V four_energies(const Symmetric &, const Symmetric &) const { return four_energies_here; }
};

template <class Law>
Law make_law(const HexGroup &group, const int64_t block, const int lane,
             const HexRelaxation *relaxation, const int n_points)
{
  if constexpr (Law::relaxes)
    return Law(group, block, lane, relaxation, n_points);
  else
    return Law(group, block, lane, relaxation);
}

/// Adds an element's dissipation: densities times the weight, for elements first + lane to end.
template <class Law>
void add_dissipated(const Law &law, const V weight, const int64_t first, const int lane,
                    const int end)
{
  alignas(64) double losses[lanes];
  Simd::store(losses, weight * law.four_losses);
  for (int l = lane; l < end; ++l)
    law.relaxation.dissipated[first + l] += losses[l - lane];
}

template <class Law, bool with_energy>
void one_point(const HexArrays &arrays, const HexGroup &group, const HexRelaxation *relaxation)
{
  const V bending = Simd::set(group.hourglass_bending),
          warping = Simd::set(group.hourglass_warping);
  const int64_t n = group.n_elements;
  for (int64_t first = 0; first < n; first += block_size)
    for (int lane = 0; lane < block_size && first + lane < n; lane += lanes)
    {
      const HexBlock &block = group.blocks[first / block_size];
      const int end         = first + lane + lanes < n ? lane + lanes : int(n - first);
      const Element e       = load(arrays.position, block, lane);

      // dN_a/dX = r_a / (4 h) at the centre
      const V to_gradient = Simd::set(0.25) / e.edge;
      V F[3][3];
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
          F[c][d] = e.mode[c][d] * to_gradient;
      const Symmetric twice_e = twice_green_strain(F);
      Law law                 = make_law<Law>(group, first / block_size, lane, relaxation, 1);
      const Symmetric S       = law.stress(0, twice_e);

      // f_a = -V P r_a / (4 h) - k q Gamma_a
      const V minus_area = Simd::set(-0.25) * e.edge * e.edge;
      const V k_bending = bending * e.edge, k_warping = warping * e.edge;
      V force[3][n_modes], P[3];
      for (int c = 0; c < 3; ++c)
      {
        first_piola_kirchhoff(F[c], S, P);
        for (int d = 0; d < 3; ++d)
          force[c][d] = minus_area * P[d];
        for (int m = st; m < rst; ++m)
          force[c][m] = Simd::zero() - k_bending * e.mode[c][m];
        force[c][rst] = Simd::zero() - k_warping * e.mode[c][rst];
      }
      scatter(force, block.entry, lane, end, arrays.force);

      const V quarter_volume = Simd::set(0.25) * e.edge * e.edge * e.edge;
      if constexpr (Law::relaxes)
        add_dissipated(law, quarter_volume, first, lane, end);
      if constexpr (with_energy)
      {
        alignas(64) double energy[2][lanes];
        Simd::store(energy[0], quarter_volume * law.four_energies(S, twice_e));
        V twice = Simd::zero();
        for (int c = 0; c < 3; ++c)
          for (int m = st; m <= rst; ++m)
            twice =
                Simd::fma((m == rst ? k_warping : k_bending) * e.mode[c][m], e.mode[c][m], twice);
        Simd::store(energy[1], Simd::set(0.5) * twice);
        for (int l = lane; l < end; ++l)
        {
          arrays.strain_energy[first + l]    = energy[0][l - lane];
          arrays.hourglass_energy[first + l] = energy[1][l - lane];
        }
      }
    }
}

template <class Law, bool with_energy>
void integrated(const HexArrays &arrays, const HexGroup &group, const HexRelaxation *relaxation)
{
  // Gauss points at r, s, t = +-1/sqrt(3), all with weight V/8.
  const V gauss = Simd::set(0.57735026918962576451), gauss2 = Simd::set(1. / 3.);
  // Derivatives along direction d vary with the two other coordinates, `first` and `second`.
  constexpr Mode with_first[3] = {rs, rs, rt}, with_second[3] = {rt, st, st};
  const int64_t n = group.n_elements;
  for (int64_t first = 0; first < n; first += block_size)
    for (int lane = 0; lane < block_size && first + lane < n; lane += lanes)
    {
      const HexBlock &block = group.blocks[first / block_size];
      const int end         = first + lane + lanes < n ? lane + lanes : int(n - first);
      const Element e       = load(arrays.position, block, lane);
      Law law               = make_law<Law>(group, first / block_size, lane, relaxation, 8);

      const V to_gradient = Simd::set(0.25) / e.edge;
      V gradient[3][3][4], piola[3][3][4]; // [component][direction][point of the other two]
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
        {
          const V scaled = gauss * to_gradient;
          at_four_points(e.mode[c][d] * to_gradient, e.mode[c][with_first[d]] * scaled,
                         e.mode[c][with_second[d]] * scaled,
                         e.mode[c][rst] * (gauss2 * to_gradient), gradient[c][d]);
          for (V &value : piola[c][d])
            value = Simd::zero();
        }

      V energy = Simd::zero();
      for (int point = 0; point < 8; ++point)
      {
        const int others[3] = {point >> 1, (point & 1) + 2 * (point >> 2), point & 3};
        V F[3][3], P[3];
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
            F[c][d] = gradient[c][d][others[d]];
        const Symmetric twice_e = twice_green_strain(F);
        const Symmetric S       = law.stress(point, twice_e);
        for (int c = 0; c < 3; ++c)
        {
          first_piola_kirchhoff(F[c], S, P);
          for (int d = 0; d < 3; ++d)
            piola[c][d][others[d]] = piola[c][d][others[d]] + P[d];
        }
        if constexpr (with_energy)
          energy = energy + law.four_energies(S, twice_e);
      }

      // f_a = -sum_g V/8 P dN_a/dX
      const V weight = Simd::set(-1. / 32.) * e.edge * e.edge;
      V force[3][n_modes];
      for (int c = 0; c < 3; ++c)
      {
        V one, first_moment[3], second_moment[3], product, warping = Simd::zero();
        for (int d = 0; d < 3; ++d)
        {
          moments_of_four_points(piola[c][d], one, first_moment[d], second_moment[d], product);
          force[c][d] = weight * one;
          warping     = warping + product;
        }
        const V scaled = weight * gauss;
        force[c][rs]   = scaled * (first_moment[0] + first_moment[1]);
        force[c][rt]   = scaled * (second_moment[0] + first_moment[2]);
        force[c][st]   = scaled * (second_moment[1] + second_moment[2]);
        force[c][rst]  = weight * gauss2 * warping;
      }
      scatter(force, block.entry, lane, end, arrays.force);

      if constexpr (Law::relaxes)
        add_dissipated(law, Simd::set(1. / 32.) * e.edge * e.edge * e.edge, first, lane, end);
      if constexpr (with_energy)
      {
        alignas(64) double nodal[lanes];
        Simd::store(nodal, Simd::set(1. / 32.) * e.edge * e.edge * e.edge * energy);
        for (int l = lane; l < end; ++l)
        {
          arrays.strain_energy[first + l]    = nodal[l - lane];
          arrays.hourglass_energy[first + l] = 0.;
        }
      }
    }
}

inline void advance(double *position, double *velocity, const double *force,
                    const double *inverse_mass, const int64_t n, const double kick,
                    const double drift)
{
  const V kick_v = Simd::set(kick), drift_v = Simd::set(drift);
  int64_t i = 0;
  for (; i + lanes <= n; i += lanes)
  {
    const V v = Simd::fma(kick_v * Simd::load(force + i), Simd::load(inverse_mass + i),
                          Simd::load(velocity + i));
    Simd::store(velocity + i, v);
    Simd::store(position + i, Simd::fma(drift_v, v, Simd::load(position + i)));
  }
  if (i == n)
    return;
  // The rest by the same operations, so that nothing depends on how nodes are shared among ranks.
  alignas(64) double rest[4][lanes] = {};
  const int n_rest                  = int(n - i);
  for (int l = 0; l < n_rest; ++l)
  {
    rest[0][l] = position[i + l];
    rest[1][l] = velocity[i + l];
    rest[2][l] = force[i + l];
    rest[3][l] = inverse_mass[i + l];
  }
  const V v = Simd::fma(kick_v * Simd::load(rest[2]), Simd::load(rest[3]), Simd::load(rest[1]));
  const V x = Simd::fma(drift_v, v, Simd::load(rest[0]));
  Simd::store(rest[1], v);
  Simd::store(rest[0], x);
  for (int l = 0; l < n_rest; ++l)
  {
    velocity[i + l] = rest[1][l];
    position[i + l] = rest[0][l];
  }
}

template <class Law, bool with_energy>
void elastic_one_point(const HexArrays &arrays, const HexGroup &group)
{
  one_point<Law, with_energy>(arrays, group, nullptr);
}
template <class Law, bool with_energy>
void elastic_integrated(const HexArrays &arrays, const HexGroup &group)
{
  integrated<Law, with_energy>(arrays, group, nullptr);
}
template <class Law, bool with_energy>
void relaxing_one_point(const HexArrays &arrays, const HexGroup &group,
                        const HexRelaxation &relaxation)
{
  one_point<Relaxing<Law, with_energy>, with_energy>(arrays, group, &relaxation);
}
template <class Law, bool with_energy>
void relaxing_integrated(const HexArrays &arrays, const HexGroup &group,
                         const HexRelaxation &relaxation)
{
  integrated<Relaxing<Law, with_energy>, with_energy>(arrays, group, &relaxation);
}

const HexKernel kernel = {Simd::name,
                          &elastic_one_point<SharedModuli, false>,
                          &elastic_one_point<SharedModuli, true>,
                          &elastic_integrated<SharedModuli, false>,
                          &elastic_integrated<SharedModuli, true>,
                          &elastic_integrated<OwnTensors, false>,
                          &elastic_integrated<OwnTensors, true>,
                          &relaxing_one_point<SharedModuli, false>,
                          &relaxing_one_point<SharedModuli, true>,
                          &relaxing_integrated<SharedModuli, false>,
                          &relaxing_integrated<SharedModuli, true>,
                          &relaxing_integrated<OwnTensors, false>,
                          &relaxing_integrated<OwnTensors, true>,
                          &advance};
} // namespace
} // namespace ricochet
