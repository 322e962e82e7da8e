// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/peridynamic_body.h"
#include "ricochet/peridynamics/plane_sums.h"

#include <cmath>

namespace ricochet
{
namespace
{
/// All points have the same mass, so the norm is the plain Euclidean one.
class PeridynamicVibration : public Vibration
{
public:
  explicit PeridynamicVibration(PeridynamicBody &body) :
    body_(body), lattice_(body.lattice()), a_(body.state().arrays),
    size_(amplitude * lattice_.box().spacing *
          std::sqrt(double(lattice_.box().n[0]) * lattice_.box().n[1] * lattice_.box().n[2]))
  {
  }

  void excite() override
  {
    // The highest modes alternate from point to point; start near one.
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const auto c = lattice_.coordinates(p);
          for (int d = 0; d < 3; ++d)
            a_.force[d][p] = ((c[0] + c[1] * (d == 1) + c[2] * (d == 2)) % 2 ? -1. : 1.) +
                             noise(Vector3(c[0], c[1], c[2]), d);
        });
  }

  double response() const override
  {
    PlaneSums<1> sums(lattice_.box().n[0]);
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          for (const double *f : a_.force)
            sums[lattice_.plane_of(p)][0] += f[p] * f[p];
        });
    return std::sqrt(sums.total(body_.communicator())[0]);
  }

  double response_of_unit() const override { return size_ * body_.point_mass(); }

  void displace(const double norm) override
  {
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const Vector3 x = lattice_.reference_position(lattice_.coordinates(p));
          for (int d = 0; d < 3; ++d)
            a_.position[d][p] = x[d] - size_ * a_.force[d][p] / norm;
        });
  }

  void evaluate() override
  {
    body_.update_ghosts();
    body_.compute_internal_forces({});
  }

  void rest() override { body_.rest(); }

private:
  PeridynamicBody &body_;
  const Lattice &lattice_;
  LatticeArrays &a_;
  double size_; // |u| [m]
};
} // namespace

std::unique_ptr<Vibration> PeridynamicBody::vibration()
{
  return std::make_unique<PeridynamicVibration>(*this);
}
} // namespace ricochet
