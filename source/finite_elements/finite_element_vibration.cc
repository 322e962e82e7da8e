// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/units.h"
#include "ricochet/finite_elements/finite_element_body.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ricochet
{
namespace
{
/// Nodes have different masses: |u|^2 = sum m u^2, |f|^2 = sum f^2/m, in which M^-1 K is symmetric.
class FiniteElementVibration : public Vibration
{
public:
  FiniteElementVibration(const MPI_Comm communicator, FiniteElementBody &body) :
    communicator_(communicator), body_(body), mesh_(body.mesh())
  {
    double finest = mesh_.box().edge;
    for (const auto &element : mesh_.elements())
      finest = std::min(finest, element.edge);
    MPI_Allreduce(MPI_IN_PLACE, &finest, 1, MPI_DOUBLE, MPI_MIN, communicator);
    finest_ = finest;
    size_   = amplitude * finest * std::sqrt(body.total_mass());
  }

  void excite() override
  {
    // The highest modes alternate from node to node of the finest cubes.
    for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    {
      const Vector3 c = (mesh_.reference_position(node) - mesh_.box().corner) / finest_;
      for (int d = 0; d < 3; ++d)
      {
        const long sum =
            std::lround(c[0]) + std::lround(c[1]) * (d == 1) + std::lround(c[2]) * (d == 2);
        body_.force()[3 * node + d] = body_.mass(node) * ((sum % 2 ? -1. : 1.) + noise(c, d));
      }
    }
  }

  double response() const override
  {
    double sum = 0.;
    for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const double f = body_.force()[3 * node + d];
        sum += f * f * body_.inverse_mass(node, d);
      }
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return std::sqrt(sum);
  }

  double response_of_unit() const override { return size_; }

  void displace(const double norm) override
  {
    for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const int i = 3 * node + d;
        body_.position()[i] =
            mesh_.reference()[i] - size_ * body_.force()[i] * body_.inverse_mass(node, d) / norm;
      }
  }

  void evaluate() override
  {
    body_.update_ghosts();
    body_.compute_internal_forces({});
  }

  void rest() override { body_.rest(); }

private:
  MPI_Comm communicator_;
  FiniteElementBody &body_;
  const HexMesh &mesh_;
  double finest_; // smallest edge [m]
  double size_;   // |u| [m sqrt(kg)]
};
} // namespace

std::unique_ptr<Vibration> FiniteElementBody::vibration()
{
  return std::make_unique<FiniteElementVibration>(communicator_, *this);
}

std::string FiniteElementBody::first_not_finite() const
{
  for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    for (const auto *field : {&position_, &velocity_, &force_})
      if (!Vector3((*field)[3 * node], (*field)[3 * node + 1], (*field)[3 * node + 2]).allFinite())
      {
        std::ostringstream text;
        text << "The motion of the element node at ("
             << mesh_.reference_position(node).transpose() / units::mm << ") mm";
        return text.str();
      }
  return "";
}
} // namespace ricochet
