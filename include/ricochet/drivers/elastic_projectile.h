// SPDX-License-Identifier: LGPL-2.1-or-later
// A projectile of finite elements, elastic: forces/elastic_body.h touched by the plates' points
// through forces/surface_contact.h. With a symmetry plane its half y > 0 is computed.
#pragma once

#include "ricochet/drivers/projectile.h"
#include "ricochet/forces/surface_contact.h"

namespace ricochet
{
class ElasticProjectile : public Projectile
{
public:
  ElasticProjectile(MPI_Comm communicator, const Scene &scene, const HexSolid &mesh,
                    const Motion &start, const FrictionLaw &law,
                    const std::vector<PlateContact> &plates);

  const Motion &motion() const override { return motion_; }
  std::pair<Vector3, Vector3> bounding_box() const override;
  SurfaceFrame surface() const override;

  void begin(bool energy) override;
  Reaction touch(std::size_t plate, PeridynamicForce &points) override;
  void advance(const Reaction &reaction, double dt) override;
  void record_work(std::size_t plate, const PeridynamicForce &points, double dt) override;

  Energies energies(const Reaction &reaction, double dt) const override;
  Momenta momenta() const override;
  double friction_work() const override;

  double squared_frequency() const override { return squared_frequency_; }
  int n_elements() const override { return static_cast<int>(elastic_.solid().cells.size()); }
  double seconds_per_step() const override { return seconds_per_step_; }

  const ElasticBody &elastic() const { return elastic_; }

private:
  double friction_power() const; // at the present velocities, of the computed part [W]
  void update_surface();

  double multiplicity_; // 2 with a symmetry plane
  ElasticBody elastic_;
  Motion motion_;
  FacetedSurface surface_;
  double reach_; // how far the surface looks for points [m]
  std::vector<SurfaceContact> contacts_; // per plate
  double squared_frequency_ = 0., seconds_per_step_ = 0.;
  double work_ = 0.; // of friction on the body, both halves [J]
};
} // namespace ricochet
