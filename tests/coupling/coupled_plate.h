// SPDX-License-Identifier: LGPL-2.1-or-later
// A plate with a peridynamic zone in a box of finite elements, and how to strain and run it.
#pragma once

#include "ricochet/coupling/far_field.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <memory>

namespace ricochet::tests
{
struct CoupledSample
{
  std::array<int, 3> n_cells{14, 14, 14};
  Zone::Cells zone{{5, 5, 5}, {9, 9, 9}};
  CouplingParameters coupling;
  FarFieldOptions far;
  double poisson_ratio        = 0.35;
  double spacing              = 1e-3; // [m]
  double critical_stretch     = std::numeric_limits<double>::infinity();
  bool mirror_y               = false;
  InfluenceFunction influence = InfluenceFunction::cone;
  double horizon_ratio        = 3.;
  MPI_Comm communicator       = MPI_COMM_WORLD;
  const char *law             = "linear peridynamic solid";
  RelaxationSeries relaxation = {};
};

/// Density 1000 kg/m^3 and K + 4 mu/3 = 1 GPa, so that c_P = 1000 m/s.
struct CoupledPlate
{
  explicit CoupledPlate(const CoupledSample &sample) : spacing(sample.spacing)
  {
    const auto stencil = make_stencil(sample.spacing, sample.horizon_ratio, sample.influence);
    zone = std::make_unique<Zone>(make_zone(sample.n_cells, stencil, sample.coupling));
    zone->grow({sample.zone});
    const double nu = sample.poisson_ratio;
    const double mu = 1e9 * (1. - 2. * nu) / (2. * (1. - nu)), K = 1e9 - 4. / 3. * mu;
    const PeridynamicMaterial material{&bond_law(sample.law), 1000., K, mu,
                                       sample.critical_stretch, sample.relaxation};
    Lattice::Box box{Vector3::Zero(), sample.spacing, {}, sample.mirror_y};
    for (int d = 0; d < 3; ++d)
      box.n[d] = 2 * sample.n_cells[d];
    points = std::make_unique<PeridynamicForce>(sample.communicator, 0, box, stencil, material,
                                                Lattice::Mask{}, nullptr, zone.get());
    auto options     = sample.far;
    options.coupling = sample.coupling;
    far              = std::make_unique<FarField>(sample.communicator, *points, *zone, options);
  }

  template <class Visitor>
  void for_each_free(Visitor &&visit)
  {
    const auto &lattice = points->lattice();
    lattice.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          if (lattice.free(p))
            visit(p, lattice.reference_position(lattice.coordinates(p)));
        });
  }

  /// Moves points and nodes to map(X) and evaluates forces and energies.
  template <class Map>
  void deform(Map &&map)
  {
    for_each_free(
        [&](const std::ptrdiff_t p, const Vector3 &X)
        {
          const Vector3 x = map(X);
          for (int d = 0; d < 3; ++d)
            points->state().arrays.position[d][p] = x[d];
        });
    auto &elements = far->elements();
    for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    {
      const Vector3 x = map(elements.mesh().reference_position(node));
      for (int d = 0; d < 3; ++d)
        elements.position()[3 * node + d] = x[d];
    }
    far->lead();
    evaluate();
  }

  void evaluate(const bool energy = true)
  {
    points->update_ghosts();
    points->evaluate(/*breaking=*/true, energy);
    far->evaluate(energy);
  }

  void advance(const double kick, const double drift)
  {
    points->advance(kick, drift);
    far->advance(kick, drift);
    far->lead();
  }

  double spacing;
  std::unique_ptr<Zone> zone;
  std::unique_ptr<PeridynamicForce> points;
  std::unique_ptr<FarField> far;
};
} // namespace ricochet::tests
