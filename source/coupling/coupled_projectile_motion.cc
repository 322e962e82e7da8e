// SPDX-License-Identifier: LGPL-2.1-or-later
// How a CoupledProjectileBody moves; what it is made of stands in coupled_projectile_body.cc.
#include "ricochet/coupling/coupled_projectile_body.h"

#include "ricochet/base/noise.h"
#include "ricochet/base/units.h"

#include <Eigen/Geometry>

#include <cmath>
#include <sstream>

namespace ricochet
{
namespace
{
Vector3 value_of(const std::array<double *, 3> &field)
{
  return {*field[0], *field[1], *field[2]};
}

class CoupledProjectileVibration : public Vibration
{
public:
  explicit CoupledProjectileVibration(CoupledProjectileBody &body) : body_(body) {}

  std::size_t size() const override { return 3 * body_.mass_points().size(); }
  double spacing() const override { return body_.spacing(); }

  void excite(std::vector<double> &u) const override
  {
    std::size_t i = 0;
    double number = 0.;
    for (const auto &point : body_.mass_points())
    {
      for (int d = 0; d < 3; ++d)
        u[i++] = std::sqrt(point.mobility[d]) * noise_at(Vector3(number, 0., 0.), d);
      ++number;
    }
  }

  void displace(const std::vector<double> &u) override
  {
    std::size_t i = 0;
    for (const auto &point : body_.mass_points())
      for (int d = 0; d < 3; ++d)
        *point.position[d] = point.reference[d] + u[i++];
    body_.interpolate_to_slaved_points();
  }

  void evaluate() override
  {
    body_.update_ghosts();
    body_.compute_internal_forces({});
  }

  void acceleration(std::vector<double> &a) const override
  {
    std::size_t i = 0;
    for (const auto &point : body_.mass_points())
      for (int d = 0; d < 3; ++d)
        a[i++] = -*point.force[d] * point.mobility[d];
  }

  double product(const std::vector<double> &x, const std::vector<double> &y) const override
  {
    double sum    = 0.;
    std::size_t i = 0;
    for (const auto &point : body_.mass_points())
      for (int d = 0; d < 3; ++d, ++i)
        sum += point.mass * x[i] * y[i];
    return sum;
  }

  void rest() override { body_.rest(); }

private:
  CoupledProjectileBody &body_;
};
} // namespace

void CoupledProjectileBody::interpolate_to_slaved_points()
{
  if (!elements_)
    return;
  auto &a = peridynamic_->state().arrays;
  for (const int i : slaved_)
    for (int d = 0; d < 3; ++d)
    {
      double x = 0.;
      for (const auto &[number, weight] : points_[i].follows)
        x += weight * *mass_points_[number].position[d];
      a.position[d][index_[i]] = x;
    }
}

void CoupledProjectileBody::compute_internal_forces(const ForceRequest &request)
{
  peridynamic_->compute_internal_forces(request);
  if (elements_)
    elements_->compute_internal_forces(request);
  distribute_slaved_forces();
  if (!request.energy)
    return;
  stored_ = 0.;
  for (const auto p : index_)
    stored_ += peridynamic_->state().arrays.energy[p];
  if (elements_)
  {
    const auto e = elements_->energies(0.);
    stored_ += e.strain + e.hourglass;
  }
}

/// Contact acts on mass points alone, so this need not wait for it.
void CoupledProjectileBody::distribute_slaved_forces()
{
  const auto &a = peridynamic_->state().arrays;
  for (const int i : slaved_)
    for (const auto &[number, weight] : points_[i].follows)
      for (int d = 0; d < 3; ++d)
        *mass_points_[number].force[d] += weight * a.force[d][index_[i]];
}

void CoupledProjectileBody::advance(const double kick, const double drift)
{
  peridynamic_->advance(kick, drift);
  if (elements_)
    elements_->advance(kick, drift);
  interpolate_to_slaved_points();
}

void CoupledProjectileBody::rest()
{
  for (const auto &point : mass_points_)
    for (int d = 0; d < 3; ++d)
    {
      *point.position[d] = point.reference[d];
      *point.velocity[d] = *point.force[d] = 0.;
    }
  interpolate_to_slaved_points();
}

Energies CoupledProjectileBody::energies(const double dt) const
{
  Energies e;
  e.strain = stored_;
  for (const auto &point : mass_points_)
    for (int d = 0; d < 3; ++d)
      e.kinetic +=
          0.5 * *point.velocity[d] * (point.mass * *point.velocity[d] + dt * *point.force[d]);
  return e;
}

Momenta CoupledProjectileBody::momenta() const
{
  Momenta m;
  for (const auto &point : mass_points_)
  {
    const Vector3 x = value_of(point.position), v = value_of(point.velocity);
    m.linear += point.mass * v;
    m.angular += point.mass * x.cross(v);
  }
  return m;
}

std::unique_ptr<Vibration> CoupledProjectileBody::vibration()
{
  return std::make_unique<CoupledProjectileVibration>(*this);
}

std::string CoupledProjectileBody::first_not_finite() const
{
  for (const auto &point : mass_points_)
    for (const auto *field : {&point.position, &point.velocity, &point.force})
      if (!value_of(*field).allFinite())
      {
        std::ostringstream text;
        text << "The motion of the projectile's mass point at ("
             << point.reference.transpose() / units::mm << ") mm";
        return text.str();
      }
  return "";
}

void CoupledProjectileBody::exchange_state(StateArchive &archive)
{
  peridynamic_->exchange_state(archive);
  if (elements_)
    elements_->exchange_state(archive);
}
} // namespace ricochet
