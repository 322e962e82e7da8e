// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/noise.h"
#include "ricochet/base/units.h"
#include "ricochet/finite_elements/hexahedral_body.h"

#include <cmath>
#include <sstream>

namespace ricochet
{
namespace
{
class HexahedralVibration : public Vibration
{
public:
  explicit HexahedralVibration(HexahedralBody &body) :
    body_(body), spacing_(smallest_edge(body.solid()))
  {
  }

  std::size_t size() const override { return body_.force().size(); }
  double spacing() const override { return spacing_; }

  void excite(std::vector<double> &u) const override
  {
    for (int node = 0; node < body_.n_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
        u[3 * node + d] =
            std::sqrt(body_.inverse_mass(3 * node + d)) * noise_at(Vector3(node, 0., 0.), d);
  }

  void displace(const std::vector<double> &u) override
  {
    for (std::size_t i = 0; i < u.size(); ++i)
      body_.position()[i] = body_.solid().nodes[i / 3][static_cast<int>(i % 3)] + u[i];
  }

  void evaluate() override { body_.compute_internal_forces({}); }

  void acceleration(std::vector<double> &a) const override
  {
    for (int i = 0; i < static_cast<int>(a.size()); ++i)
      a[i] = -body_.force()[i] * body_.inverse_mass(i);
  }

  double product(const std::vector<double> &x, const std::vector<double> &y) const override
  {
    double sum = 0.;
    for (int i = 0; i < static_cast<int>(x.size()); ++i)
      sum += body_.node_mass(i / 3) * x[i] * y[i];
    return sum;
  }

  void rest() override { body_.rest(); }

private:
  HexahedralBody &body_;
  double spacing_; // smallest edge [m]
};
} // namespace

std::unique_ptr<Vibration> HexahedralBody::vibration()
{
  return std::make_unique<HexahedralVibration>(*this);
}

std::string HexahedralBody::first_not_finite() const
{
  for (int node = 0; node < n_nodes(); ++node)
    for (const auto *field : {&position_, &velocity_, &force_})
      if (!Vector3((*field)[3 * node], (*field)[3 * node + 1], (*field)[3 * node + 2]).allFinite())
      {
        std::ostringstream text;
        text << "The motion of the node at (" << solid_.nodes[node].transpose() / units::mm
             << ") mm";
        return text.str();
      }
  return "";
}
} // namespace ricochet
