// SPDX-License-Identifier: LGPL-2.1-or-later
// A projectile of finite elements, elastic: finite_elements/hexahedral_body.h. With a symmetry
// plane its half y > 0 is computed.
#pragma once

#include "deformable_projectile.h"
#include "ricochet/finite_elements/hexahedral_body.h"

namespace ricochet
{
/// Of a mesh that stands for all that is computed of the projectile: its mass evenly spread.
FiniteElementMaterial elastic_material(const Scene &scene, const HexSolid &mesh);

class FiniteElementProjectile : public DeformableProjectile
{
public:
  FiniteElementProjectile(MPI_Comm communicator, const Scene &scene, const HexSolid &mesh,
                          const Motion &start, const FrictionLaw &law,
                          const std::vector<PlateContact> &plates);

  double squared_frequency() const override { return squared_frequency_; }
  std::string parts() const override
  {
    const auto halves = static_cast<std::size_t>(elastic_.multiplicity());
    return std::to_string(halves * elastic_.solid().cells.size()) + " hexahedra";
  }
  double seconds_per_step() const override { return seconds_per_step_; }

  const HexahedralBody &elastic() const { return elastic_; }

private:
  Body &deformed() override { return elastic_; }
  const Body &deformed() const override { return elastic_; }
  SurfaceNodes nodes() override
  {
    return {elastic_.position(), elastic_.velocity(), elastic_.force(), mobility_};
  }
  std::vector<double> present_velocities(double kick) override;
  Motion nearest_motion(const double kick) const override
  {
    return elastic_.rigid_motion(kick / 2.);
  }

  HexahedralBody elastic_;
  std::vector<double> mobility_; // per node [1/kg]
  double squared_frequency_ = 0., seconds_per_step_ = 0.;
};
} // namespace ricochet
