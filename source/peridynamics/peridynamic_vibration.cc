// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/noise.h"
#include "ricochet/peridynamics/peridynamic_body.h"
#include "ricochet/peridynamics/plane_sums.h"

namespace ricochet
{
namespace
{
class PeridynamicVibration : public Vibration
{
public:
  explicit PeridynamicVibration(PeridynamicBody &body) :
    body_(body), lattice_(body.lattice()), a_(body.state().arrays)
  {
  }

  std::size_t size() const override { return 3 * lattice_.n_owned_points(); }
  double spacing() const override { return lattice_.box().spacing; }

  void excite(std::vector<double> &u) const override
  {
    std::size_t i = 0;
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const auto c = lattice_.coordinates(p);
          for (int d = 0; d < 3; ++d)
            u[i++] = noise_at(Vector3(c[0], c[1], c[2]), d); // all masses are equal
        });
  }

  void displace(const std::vector<double> &u) override
  {
    std::size_t i = 0;
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const Vector3 x = lattice_.reference_position(lattice_.coordinates(p));
          for (int d = 0; d < 3; ++d)
            a_.position[d][p] = x[d] + u[i++];
        });
  }

  void evaluate() override
  {
    body_.update_ghosts();
    body_.compute_internal_forces({});
  }

  void acceleration(std::vector<double> &a) const override
  {
    std::size_t i = 0;
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          for (const double *f : a_.force)
            a[i++] = -f[p] / body_.point_mass();
        });
  }

  double product(const std::vector<double> &x, const std::vector<double> &y) const override
  {
    PlaneSums<1> sums(lattice_.box().n[0]);
    std::size_t i = 0;
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          for (int d = 0; d < 3; ++d, ++i)
            sums[lattice_.plane_of(p)][0] += x[i] * y[i];
        });
    return body_.point_mass() * sums.total(body_.communicator())[0];
  }

  void rest() override { body_.rest(); }

private:
  PeridynamicBody &body_;
  const Lattice &lattice_;
  LatticeArrays &a_;
};
} // namespace

std::unique_ptr<Vibration> PeridynamicBody::vibration()
{
  return std::make_unique<PeridynamicVibration>(*this);
}
} // namespace ricochet
