// SPDX-License-Identifier: LGPL-2.1-or-later
// A plate with a peridynamic zone in a box of finite elements, and how to strain and run it.
#pragma once

#include "ricochet/coupling/coupled_plate.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace ricochet::tests
{
struct CoupledSample
{
  std::array<int, 3> n_cells{14, 14, 14};
  Zone::Cells zone{{5, 5, 5}, {9, 9, 9}};
  std::vector<Zone::Cells> more_of_zone;
  std::optional<Zone::Cells> limit; // of a zone that grows
  int pad_layers = 0;               // 0: what the method asks for
  CouplingParameters coupling;
  CoupledPlateOptions far;
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

/// I plus the strain with this number (11, 22, 33, 23, 13, 12; shear in the engineering sense).
inline Eigen::Matrix3d strained(const int number, const double strain)
{
  constexpr int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(row[number], column[number]) += 0.5 * strain;
  F(column[number], row[number]) += 0.5 * strain;
  return F;
}

/// Density 1000 kg/m^3 and K + 4 mu/3 = 1 GPa, so that c_P = 1000 m/s.
struct PlateModel
{
  explicit PlateModel(const CoupledSample &sample) :
    spacing(sample.spacing), corrects_mass(sample.coupling.correct_mass)
  {
    const auto stencil = make_stencil(sample.spacing, sample.horizon_ratio, sample.influence);
    auto own_zone      = std::make_unique<Zone>(
        sample.pad_layers > 0
                 ? Zone(sample.n_cells, stencil.reach, BlendFunction::step, sample.pad_layers)
                 : make_zone(sample.n_cells, stencil, sample.coupling));
    zone = own_zone.get();
    if (sample.limit)
      zone->set_limit(*sample.limit);
    zone->grow({sample.zone});
    zone->grow(sample.more_of_zone);
    const double nu = sample.poisson_ratio;
    const double mu = 1e9 * (1. - 2. * nu) / (2. * (1. - nu)), K = 1e9 - 4. / 3. * mu;
    const PeridynamicMaterial material{&bond_law(sample.law), 1000., K, mu, sample.critical_stretch,
                                       sample.relaxation};
    Lattice::Box box{Vector3::Zero(), sample.spacing, {}, sample.mirror_y};
    for (int d = 0; d < 3; ++d)
      box.n[d] = zone->points_per_edge() * sample.n_cells[d];
    auto own_points  = std::make_unique<PeridynamicBody>(sample.communicator, 0, box, stencil,
                                                        material, Lattice::Mask{}, nullptr, zone);
    points           = own_points.get();
    auto options     = sample.far;
    options.coupling = sample.coupling;
    far              = std::make_unique<CoupledPlate>(sample.communicator, std::move(own_zone),
                                         std::move(own_points), options);
  }

  static constexpr double density = 1000., modulus = 1e9, p_wave_speed = 1000.; // [SI]
  double edge() const { return zone->points_per_edge() * spacing; }             // of a cell [m]

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

  /// Largest component of a force on a free point or a node whose reference position is accepted
  /// [N]. Collective.
  template <class Accept>
  double largest_force(Accept &&accept)
  {
    double largest = 0.;
    for_each_free(
        [&](const std::ptrdiff_t p, const Vector3 &X)
        {
          for (int d = 0; d < 3 && accept(X); ++d)
            largest = std::max(largest, std::abs(points->state().arrays.force[d][p]));
        });
    const auto &elements = far->elements();
    for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
      for (int d = 0; d < 3 && accept(elements.mesh().reference_position(node)); ++d)
        largest = std::max(largest, std::abs(elements.force()[3 * node + d]));
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    return largest;
  }

  /// Moves points and nodes to map(X) and evaluates forces and energies.
  template <class Map>
  void deform(Map &&map)
  {
    points->end_step();
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
    far->interpolate_to_slaved_points();
    evaluate();
  }

  void evaluate(const bool energy = true)
  {
    points->update_ghosts();
    points->break_bonds();
    far->compute_internal_forces({energy});
    far->complete_forces();
  }

  /// Velocities of free points and nodes become v(X), half a step before the present.
  template <class Field>
  void set_velocity(Field &&v)
  {
    for_each_free(
        [&](const std::ptrdiff_t p, const Vector3 &X)
        {
          const Vector3 value = v(X);
          for (int d = 0; d < 3; ++d)
            points->state().arrays.velocity[d][p] = value[d];
        });
    auto &elements = far->elements();
    auto velocity  = elements.velocity();
    for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    {
      const Vector3 value = v(elements.mesh().reference_position(node));
      for (int d = 0; d < 3; ++d)
        if (elements.inverse_mass(node, d) > 0.)
          velocity[3 * node + d] = value[d];
    }
    elements.set_velocity(velocity);
    far->interpolate_to_slaved_points();
  }

  void advance(const double kick, const double drift) { far->advance(kick, drift); }

  double spacing; // dx [m]
  bool corrects_mass;
  Zone *zone; // the plate's, and its points
  PeridynamicBody *points;
  std::unique_ptr<CoupledPlate> far;
};
} // namespace ricochet::tests
