// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exact_sum.h"
#include "ricochet/base/noise.h"
#include "ricochet/base/units.h"
#include "ricochet/finite_elements/finite_element_body.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ricochet
{
namespace
{
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
  }

  std::size_t size() const override { return 3 * static_cast<std::size_t>(mesh_.n_owned_nodes()); }
  double spacing() const override { return finest_; }

  void excite(std::vector<double> &u) const override
  {
    for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    {
      const Vector3 place = (mesh_.reference_position(node) - mesh_.box().corner) / finest_;
      for (int d = 0; d < 3; ++d)
        u[3 * node + d] = std::sqrt(body_.inverse_mass(node, d)) * noise_at(place, d);
    }
  }

  void displace(const std::vector<double> &u) override
  {
    for (std::size_t i = 0; i < u.size(); ++i)
      body_.position()[i] = mesh_.reference()[i] + u[i];
  }

  void evaluate() override
  {
    body_.update_ghosts();
    body_.compute_internal_forces({});
    body_.complete_forces();
  }

  void acceleration(std::vector<double> &a) const override
  {
    for (int i = 0; i < static_cast<int>(a.size()); ++i)
      a[i] = -body_.force()[i] * body_.inverse_mass(i / 3, i % 3);
  }

  double product(const std::vector<double> &x, const std::vector<double> &y) const override
  {
    ExactSum sum;
    for (int i = 0; i < static_cast<int>(x.size()); ++i)
      sum.add(body_.mass(i / 3) * x[i] * y[i]);
    return total(communicator_, sum);
  }

  void rest() override { body_.rest(); }

private:
  MPI_Comm communicator_;
  FiniteElementBody &body_;
  const HexMesh &mesh_;
  double finest_; // smallest edge [m]
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
