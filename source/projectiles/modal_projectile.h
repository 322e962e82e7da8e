// SPDX-License-Identifier: LGPL-2.1-or-later
// A projectile that is rigid but for its lowest eigenmodes: finite_elements/modal_body.h. Modes are
// those of the mesh that a projectile of finite elements has; points touch the same faces.
#pragma once

#include "deformable_projectile.h"
#include "mode_finder.h"
#include "ricochet/finite_elements/modal_body.h"
#include "skin_stress.h"

namespace ricochet
{
class ModalProjectile : public DeformableProjectile
{
public:
  /// Rigid until resolve() is called. `start`: of the centroid.
  ModalProjectile(MPI_Comm communicator, const Scene &scene, const HexSolid &mesh,
                  const Motion &start, const FrictionLaw &law,
                  const std::vector<PlateContact> &plates);

  void resolve(double squared_frequency) override;

  SurfaceFrame surface() const override;
  void advance(double kick, double drift) override;
  void exchange_state(StateArchive &archive) override;
  double largest_von_mises() const override { return largest_von_mises_; }

  double squared_frequency() const override { return squared_frequency_; }
  std::string parts() const override;
  std::string description() const override;
  double seconds_per_step() const override { return 0.; }

  const ModalBody &elastic() const { return elastic_; }

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

  ModeFinder::Loads pushes_on_nose() const;
  void measure_skin(const std::vector<PlateContact> &plates);
  int n_below(double squared_frequency) const;
  void find_modes_below(double squared_frequency);

  HexahedralBody mesh_;
  Skin skin_;
  ModalBody elastic_;
  SkinStress stress_;
  ModeFinder finder_;
  int n_asked_; // 0: automatic
  ProjectileModes found_;
  std::vector<double> stiffness_; // of the plates' points on a skin node's share [N/m]
  std::vector<Vector3> normal_;   // of the skin at its nodes
  std::vector<double> mobility_;  // per skin node [1/kg]
  double largest_von_mises_ = 0.; // so far [Pa]
  double squared_frequency_ = 0., plates_ = 0.; // of the body and the plates [1/s^2]
};
} // namespace ricochet
