// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/plate_joint.h"

#include "field_values.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/peridynamics/plane_archive.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
/// Of two halves of a layer, one behind the other.
double in_series(const double one, const double other)
{
  return 2. * one * other / (one + other);
}

double p_wave_modulus(const PeridynamicMaterial &material)
{
  return material.bulk_modulus + 4. / 3. * material.shear_modulus;
}
} // namespace

PlateJoint::PlateJoint(const MPI_Comm communicator, PeridynamicBody &above, PeridynamicBody &below,
                       const Strength &strength) :
  communicator_(communicator),
  above_(above), below_(below), strength_(strength),
  modulus_(in_series(p_wave_modulus(above.material()), p_wave_modulus(below.material()))),
  shear_modulus_(in_series(above.material().shear_modulus, below.material().shear_modulus)),
  stored_(above.lattice().box().n[0]), released_(above.lattice().box().n[0])
{
  check();
  find_sites();
}

void PlateJoint::check() const
{
  const auto &a = above_.lattice().box(), &b = below_.lattice().box();
  const double top = b.corner.z() + b.n[2] * b.spacing; // of the lower body [m]
  // Corners are sums of a few lengths: equal to rounding, far below a thousandth of the spacing.
  const auto same  = [&](const double x, const double y)
  { return std::abs(x - y) < 1e-3 * a.spacing; };
  if (above_.lattice().zone() != nullptr || below_.lattice().zone() != nullptr ||
      !same(a.spacing, b.spacing) || a.n[0] != b.n[0] || a.n[1] != b.n[1] ||
      !same(a.corner.x(), b.corner.x()) || !same(a.corner.y(), b.corner.y()) ||
      !same(a.corner.z(), top) ||
      above_.lattice().plane_starts() != below_.lattice().plane_starts())
    throw InputError("Plates that are joined lie on each other, point on point: give them the same "
                     "length, width, 'Grid spacing' and 'Horizon ratio', no 'Gap', and no finite "
                     "elements.");
}

void PlateJoint::find_sites()
{
  // A point of this rank has springs to sites of the planes beside its own, and whether these break
  // depends on one plane more: stencils reach two planes or more, so all of that is here, ghosts
  // and images included, and every rank that sees a site breaks it in the same step.
  const auto &l = above_.lattice();
  const auto &n = l.box().n;
  for (int x = std::max(0, l.first_plane() - 1);
       x < std::min(n[0], l.first_plane() + l.n_planes() + 1); ++x)
    for (int y = l.box().mirror_y ? -1 : 0; y < n[1]; ++y)
      add_site({x, y, 0});
}

void PlateJoint::add_site(const std::array<int, 3> &c)
{
  const Lattice &la = above_.lattice(), &lb = below_.lattice();
  const auto &n    = lb.box().n;
  const auto point = [&](const int x, const int y) { return lb.index(x, y, n[2] - 1); };
  const auto above = la.index(c[0], c[1], 0);
  if (!la.exists(above) || !lb.exists(point(c[0], c[1])))
    return;
  const double dx         = la.box().spacing;
  const double diagonal   = shear_modulus_ * dx;
  const std::size_t first = springs_.size();
  springs_.push_back({point(c[0], c[1]), 0., dx});
  const int lowest_y = lb.box().mirror_y ? -2 : 0; // the image of an image's neighbour
  for (const auto &[x, y] :
       {std::pair<int, int>{c[0] - 1, c[1]}, {c[0], c[1] - 1}, {c[0], c[1] + 1}, {c[0] + 1, c[1]}})
    if (x >= 0 && x < n[0] && y >= lowest_y && y < n[1] && lb.exists(point(x, y)))
      springs_.push_back({point(x, y), diagonal, std::sqrt(2.) * dx});
  const auto n_diagonals    = static_cast<double>(springs_.size() - first - 1);
  springs_[first].stiffness = modulus_ * dx - n_diagonals / 2. * diagonal;
  sites_.push_back({above, first, springs_.size()});
}

Vector3 PlateJoint::apart(const Site &site, const Spring &spring) const
{
  return at(below_.state().arrays.position, spring.below) -
         at(above_.state().arrays.position, site.above);
}

bool PlateJoint::fails(const Site &site) const
{
  Vector3 force = Vector3::Zero(); // on the upper point
  for (std::size_t s = site.first; s < site.last; ++s)
  {
    const auto &spring   = springs_[s];
    const Vector3 r      = apart(site, spring);
    const double present = r.norm();
    force += spring.stiffness * (present - spring.length) / present * r;
  }
  const double area    = std::pow(above_.lattice().box().spacing, 2);
  const Vector3 across = apart(site, springs_[site.first]).normalized();
  const double tension = force.dot(across);
  const double shear   = (force - tension * across).norm();
  return std::pow(std::max(tension, 0.) / (strength_.tension * area), 2) +
             std::pow(shear / (strength_.shear * area), 2) >=
         1.;
}

void PlateJoint::book(const Site &site, const Spring &spring, const double energy,
                      PlaneSums<1> &sums) const
{
  if (above_.lattice().owned(site.above))
    sums[above_.lattice().plane_of(site.above)][0] += 0.5 * energy;
  if (below_.lattice().owned(spring.below))
    sums[below_.lattice().plane_of(spring.below)][0] += 0.5 * energy;
}

void PlateJoint::act(Site &site, const double dt)
{
  site.broken   = fails(site);
  const auto &a = above_.state().arrays, &b = below_.state().arrays;
  for (std::size_t s = site.first; s < site.last; ++s)
  {
    const auto &spring     = springs_[s];
    const Vector3 r        = apart(site, spring);
    const double present   = r.norm();
    const double extension = present - spring.length;
    if (site.broken)
    {
      // What the leapfrog scheme holds between its steps (doc/theory.md, energy balance).
      const Vector3 step  = dt * (at(b.velocity, spring.below) - at(a.velocity, site.above));
      const double before = (r - step).norm() - spring.length;
      book(site, spring, 0.5 * spring.stiffness * extension * before, released_);
      continue;
    }
    book(site, spring, 0.5 * spring.stiffness * extension * extension, stored_);
    const Vector3 force = spring.stiffness * extension / present * r; // on the upper point
    for (int d = 0; d < 3; ++d)
    {
      if (above_.lattice().owned(site.above))
        a.force[d][site.above] += force[d];
      if (below_.lattice().owned(spring.below))
        b.force[d][spring.below] -= force[d];
    }
  }
}

void PlateJoint::add_forces(const double dt)
{
  stored_.clear();
  for (auto &site : sites_)
    if (!site.broken)
      act(site, dt);
}

double PlateJoint::whole(const PlaneSums<1> &sums) const
{
  return above_.multiplicity() * sums.total(communicator_)[0];
}

double PlateJoint::broken_share() const
{
  double n[2] = {0., 0.};
  for (const auto &site : sites_)
    if (above_.lattice().owned(site.above))
    {
      n[0] += 1.;
      n[1] += site.broken;
    }
  MPI_Allreduce(MPI_IN_PLACE, n, 2, MPI_DOUBLE, MPI_SUM, communicator_);
  return n[0] > 0. ? n[1] / n[0] : 0.;
}

double PlateJoint::squared_frequency(const PeridynamicBody &body) const
{
  if (&body != &above_ && &body != &below_)
    return 0.;
  // The stiffest way is along the normal, M dx; two ends in antiphase double it.
  return 2. * modulus_ * body.lattice().box().spacing / body.point_mass();
}

void PlateJoint::exchange_state(StateArchive &archive)
{
  // By their places. Ranks have sites in common: who owns the plane saves them.
  const Lattice &lattice = above_.lattice();
  std::vector<std::int64_t> places;
  std::vector<double> broken;
  for (const auto &site : sites_)
  {
    const auto at   = lattice.coordinates(site.above);
    const int plane = at[0] - lattice.first_plane();
    if (!archive.is_restoring() && (plane < 0 || plane >= lattice.n_planes()))
      continue;
    places.push_back((static_cast<std::int64_t>(at[0]) << 32) + at[1]);
    broken.push_back(site.broken ? 1. : 0.);
  }
  archive.rows("broken", places, broken, 1);
  if (archive.is_restoring())
    for (std::size_t i = 0; i < sites_.size(); ++i)
      sites_[i].broken = broken[i] != 0.;
  PlaneArchive(archive, communicator_, lattice).sums("released energy", released_);
}
} // namespace ricochet
