// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/point_stress.h"

namespace ricochet
{
namespace
{
Vector3 at(const double *const field[3], const std::ptrdiff_t p)
{
  return {field[0][p], field[1][p], field[2][p]};
}

/// The sum of tension y (x) y / |y| over bonds [N m]. Not a matrix: the sums stay in registers.
class Virial
{
public:
  void add(const double tension, const Vector3 &y, const double inverse_length)
  {
    const double t = tension * inverse_length;
    xx_ += t * y[0] * y[0];
    yy_ += t * y[1] * y[1];
    zz_ += t * y[2] * y[2];
    yz_ += t * y[1] * y[2];
    xz_ += t * y[0] * y[2];
    xy_ += t * y[0] * y[1];
  }
  Eigen::Matrix3d tensor() const
  {
    Eigen::Matrix3d sum;
    sum << xx_, xy_, xz_, xy_, yy_, yz_, xz_, yz_, zz_;
    return sum;
  }

private:
  double xx_ = 0., yy_ = 0., zz_ = 0., yz_ = 0., xz_ = 0., xy_ = 0.;
};
} // namespace

PointStress::PointStress(const PeridynamicBody &body) :
  body_(body), shifts_(body.lattice().shifts())
{
  // Also of laws whose tensions do not depend on theta.
  const auto &stencil = body.lattice().stencil();
  const auto family =
      family_constants(stencil, body.material().bulk_modulus, body.material().shear_modulus);
  for (const auto &o : stencil.offsets)
    dilatation_.push_back(3. * o.omega * o.length * family.volume / family.weighted_volume);
}

void PointStress::find_bonds(const std::ptrdiff_t point)
{
  const auto &arrays    = body_.state().arrays;
  const auto &constants = body_.bond_constants();
  bonds_.clear();
  for (std::size_t k = 0; k < shifts_.size(); ++k)
    for (const bool forward : {true, false})
    {
      const std::ptrdiff_t other = forward ? point + shifts_[k] : point - shifts_[k];
      const std::ptrdiff_t first = forward ? point : other;
      const bool cracked         = first >= 0 && is_set(arrays.cracked, first, k);
      if (first < 0 || !(cracked || is_set(arrays.bonds, first, k)))
        continue;
      const Vector3 now   = at(arrays.position, other) - at(arrays.position, point);
      const double length = now.norm(), extension = length - constants[k].length;
      const double elastic =
          extension - (body_.flow() == nullptr ? 0. : body_.flow()->plastic_extension(first, k));
      if (!cracked || elastic < 0.)
        bonds_.push_back({k, first, now, 1. / length, extension, elastic, cracked});
    }
}

StressState PointStress::of(const std::ptrdiff_t point)
{
  const auto &law       = *body_.material().law;
  const auto &constants = body_.bond_constants();
  find_bonds(point);
  double theta = 0.;
  for (const Bond &bond : bonds_)
    theta += bond.cracked ? 0. : dilatation_[bond.offset] * bond.extension;
  // Half of a tension is the point's own if both ends have its theta; half of the energy too.
  Virial virial;
  double energy = body_.point_stiffness() * theta * theta;
  for (const Bond &bond : bonds_)
  {
    const auto &c     = constants[bond.offset];
    const double push = body_.cracked_share() * c.extension * bond.elastic;
    virial.add(0.5 * (bond.cracked ? push : law.tension(c, bond.elastic, 2. * theta)), bond.now,
               bond.inverse);
    energy += bond.cracked ? 0.25 * push * bond.elastic : 0.5 * law.bond_energy(c, bond.elastic);
  }
  StressState state{virial.tensor(), theta, energy};
  if (body_.history() != nullptr)
    relax(point, state);
  state.stress /= body_.point_volume();
  state.energy_density /= body_.point_volume();
  return state;
}

/// With e_b and theta_b of the branches (bond_viscosity.h) the own tension is smaller by
/// c/2 sum lambda_k (e_b,k - |xi| theta_b,k/3), c the bond's tension per extension.
void PointStress::relax(const std::ptrdiff_t point, StressState &state) const
{
  const auto &history   = *body_.history();
  const auto &branches  = history.branches();
  const auto &constants = body_.bond_constants();
  const double *half    = body_.state().arrays.half_weight;
  const double weight   = half == nullptr ? 1. : 2. * half[point];
  const double theta    = state.dilatation;
  double theta_back = 0., squares = 0.; // sums of lambda_k theta_b,k and of what the springs hold
  for (int b = 0; b < history.n_branches() && weight > 0.; ++b)
  {
    const double held = history.held_of_theta(point, b, weight * theta) / weight;
    theta_back += branches[b].share * (theta - held);
    squares += branches[b].share * (held * held - theta * theta);
  }
  Virial virial;
  double energy = -5. / 6. * body_.material().shear_modulus * body_.point_volume() * squares;
  for (const Bond &bond : bonds_)
  {
    if (bond.cracked) // has no memory
      continue;
    const auto &c  = constants[bond.offset];
    const double e = bond.extension;
    double back = 0., springs = 0.;
    for (int b = 0; b < history.n_branches(); ++b)
    {
      const double held = history.held_of_bond(bond.first, bond.offset, b, e);
      back += branches[b].share * (e - held);
      springs += branches[b].share * (held * held - e * e);
    }
    virial.add(0.5 * c.extension * (c.length / 3. * theta_back - back), bond.now, bond.inverse);
    energy += 0.25 * c.extension * springs;
  }
  state.stress += virial.tensor();
  state.energy_density += energy;
}
} // namespace ricochet
