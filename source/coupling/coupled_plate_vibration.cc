// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exact_sum.h"
#include "ricochet/base/noise.h"
#include "ricochet/coupling/coupled_plate.h"

#include <cmath>

namespace ricochet
{
namespace
{
/// Free points, then nodes.
class CoupledPlateVibration : public Vibration
{
public:
  explicit CoupledPlateVibration(CoupledPlate &plate) :
    communicator_(plate.communicator()), plate_(plate), points_(plate.points()),
    elements_(plate.elements()), lattice_(points_.lattice()), a_(points_.state().arrays)
  {
    for_each_free([&](std::ptrdiff_t) { n_of_points_ += 3; });
  }

  std::size_t size() const override
  {
    return n_of_points_ + 3 * static_cast<std::size_t>(elements_.mesh().n_owned_nodes());
  }
  double spacing() const override { return lattice_.box().spacing; }

  void excite(std::vector<double> &u) const override
  {
    const auto place = [&](const Vector3 &X) -> Vector3
    { return (X - lattice_.box().corner) / lattice_.box().spacing; };
    std::size_t i = 0;
    for_each_free(
        [&](const std::ptrdiff_t p)
        {
          for (int d = 0; d < 3; ++d)
            u[i++] = noise_at(place(reference(p)), d) / std::sqrt(points_.point_mass());
        });
    const auto &mesh = elements_.mesh();
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
        u[i++] = std::sqrt(elements_.inverse_mass(node, d)) *
                 noise_at(place(mesh.reference_position(node)), d);
  }

  void displace(const std::vector<double> &u) override
  {
    std::size_t i = 0;
    for_each_free(
        [&](const std::ptrdiff_t p)
        {
          const Vector3 x = reference(p);
          for (int d = 0; d < 3; ++d)
            a_.position[d][p] = x[d] + u[i++];
        });
    for (std::size_t k = 0; i < u.size(); ++k)
      elements_.position()[k] = elements_.mesh().reference()[k] + u[i++];
  }

  void evaluate() override
  {
    plate_.interpolate_to_slaved_points();
    plate_.update_ghosts();
    plate_.compute_internal_forces({});
    plate_.complete_forces();
  }

  void acceleration(std::vector<double> &a) const override
  {
    std::size_t i = 0;
    for_each_free(
        [&](const std::ptrdiff_t p)
        {
          for (const double *f : a_.force)
            a[i++] = -f[p] / points_.point_mass();
        });
    for (int k = 0; i < a.size(); ++k)
      a[i++] = -elements_.force()[k] * elements_.inverse_mass(k / 3, k % 3);
  }

  double product(const std::vector<double> &x, const std::vector<double> &y) const override
  {
    ExactSum sum;
    std::size_t i = 0;
    for (; i < n_of_points_; ++i)
      sum.add(points_.point_mass() * x[i] * y[i]);
    for (int k = 0; i < x.size(); ++k, ++i)
      sum.add(elements_.mass(k / 3) * x[i] * y[i]);
    return total(communicator_, sum);
  }

  void rest() override { plate_.rest(); }

private:
  template <class Visitor>
  void for_each_free(Visitor &&visit) const
  {
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          if (lattice_.free(p))
            visit(p);
        });
  }
  Vector3 reference(const std::ptrdiff_t p) const
  {
    return lattice_.reference_position(lattice_.coordinates(p));
  }

  MPI_Comm communicator_;
  CoupledPlate &plate_;
  PeridynamicBody &points_;
  FiniteElementBody &elements_;
  const Lattice &lattice_;
  LatticeArrays &a_;
  std::size_t n_of_points_ = 0; // components
};
} // namespace

std::unique_ptr<Vibration> CoupledPlate::vibration()
{
  return std::make_unique<CoupledPlateVibration>(*this);
}
} // namespace ricochet
