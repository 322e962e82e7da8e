// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/units.h"
#include "ricochet/finite_elements/hexahedral_body.h"

#include <cmath>
#include <sstream>

namespace ricochet
{
namespace
{
/// As FiniteElementVibration: |u|^2 = sum m u^2, |f|^2 = sum f^2/m.
class HexahedralVibration : public Vibration
{
public:
  explicit HexahedralVibration(HexahedralBody &body) :
    body_(body), size_(amplitude * smallest_edge(body.solid()) * std::sqrt(body.mass()))
  {
  }

  void excite() override
  {
    // Weighted by 1/m: the highest modes live where the smallest elements are.
    for (int node = 0; node < body_.n_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
        body_.force()[3 * node + d] = noise(Vector3(node, 0., 0.), d);
  }

  double response() const override
  {
    double sum = 0.;
    for (std::size_t i = 0; i < body_.force().size(); ++i)
      sum += body_.force()[i] * body_.force()[i] * body_.inverse_mass(static_cast<int>(i));
    return std::sqrt(sum);
  }

  double response_of_unit() const override { return size_; }

  void displace(const double norm) override
  {
    for (int node = 0; node < body_.n_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const int i = 3 * node + d;
        body_.position()[i] =
            body_.solid().nodes[node][d] - size_ * body_.force()[i] * body_.inverse_mass(i) / norm;
      }
  }

  void evaluate() override { body_.compute_internal_forces({}); }
  void rest() override { body_.rest(); }

private:
  HexahedralBody &body_;
  double size_; // |u| [m sqrt(kg)]
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
