// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/coupled_plate.h"

#include <cmath>

namespace ricochet
{
namespace
{
/// Free points and nodes; |u|^2 = sum m u^2, |f|^2 = f M^-1 f, in which M^-1 K is symmetric, the
/// corrected mass of the nodes included.
class CoupledPlateVibration : public Vibration
{
public:
  explicit CoupledPlateVibration(CoupledPlate &plate) :
    communicator_(plate.communicator()), plate_(plate), points_(plate.points()),
    elements_(plate.elements()), lattice_(points_.lattice()), a_(points_.state().arrays)
  {
    double mass = elements_.total_mass();
    double own  = 0.;
    for_each_free([&](std::ptrdiff_t) { own += points_.point_mass(); });
    MPI_Allreduce(MPI_IN_PLACE, &own, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    size_ = amplitude * lattice_.box().spacing * std::sqrt(mass + own);
  }

  void excite() override
  {
    // The highest modes alternate from point to point; all symmetry classes take part.
    const auto start = [&](const Vector3 &X, const int d)
    {
      const Vector3 c = (X - lattice_.box().corner) / lattice_.box().spacing;
      const long sum  = std::lround(std::floor(c[0])) + std::lround(std::floor(c[1])) * (d == 1) +
                       std::lround(std::floor(c[2])) * (d == 2);
      return (sum % 2 ? -1. : 1.) + noise(c, d);
    };
    for_each_free(
        [&](const std::ptrdiff_t p)
        {
          for (int d = 0; d < 3; ++d)
            a_.force[d][p] = points_.point_mass() * start(reference(p), d);
        });
    const auto &mesh = elements_.mesh();
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
        elements_.force()[3 * node + d] =
            elements_.mass(node) * start(0.5 * mesh.reference_position(node), d);
  }

  double response() const override
  {
    double sum = elements_.squared_force();
    for_each_free(
        [&](const std::ptrdiff_t p)
        {
          for (const double *f : a_.force)
            sum += f[p] * f[p] / points_.point_mass();
        });
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return std::sqrt(sum);
  }

  double response_of_unit() const override { return size_; }

  void displace(const double norm) override
  {
    const double factor = -size_ / norm;
    for_each_free(
        [&](const std::ptrdiff_t p)
        {
          const Vector3 x = reference(p);
          for (int d = 0; d < 3; ++d)
            a_.position[d][p] = x[d] + factor * a_.force[d][p] / points_.point_mass();
        });
    const auto &mesh = elements_.mesh();
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const int i = 3 * node + d;
        elements_.position()[i] =
            mesh.reference()[i] + factor * elements_.force()[i] * elements_.inverse_mass(node, d);
      }
  }

  void evaluate() override
  {
    plate_.interpolate_to_slaved_points();
    plate_.update_ghosts();
    plate_.compute_internal_forces({});
    plate_.complete_forces();
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
  double size_; // |u| [m sqrt(kg)]
};
} // namespace

std::unique_ptr<Vibration> CoupledPlate::vibration()
{
  return std::make_unique<CoupledPlateVibration>(*this);
}
} // namespace ricochet
