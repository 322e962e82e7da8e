// SPDX-License-Identifier: LGPL-2.1-or-later
// Static equilibrium of a coupled plate, K u = r, by conjugate gradients with the very force
// routines that are integrated in time. On one rank. Small displacements: about a millionth of a
// spacing, so that the routines are linear to 1e-6 and free of rounding to 1e-9.
#pragma once

#include "support/coupled_plate.h"

#include <functional>

namespace ricochet::tests
{
class StaticSolution
{
public:
  using Vector = Eigen::VectorXd; // three entries per free point, then per node

  /// `held`: components of nodes and points that keep their displacement.
  StaticSolution(PlateModel &plate, const std::function<bool(const Vector3 &, int)> &held) :
    plate_(plate)
  {
    if (plate.corrects_mass)
      throw std::logic_error("corrected forces are not those of the static problem");
    plate.for_each_free(
        [&](const std::ptrdiff_t p, const Vector3 &X)
        {
          points_.push_back(p);
          reference_.push_back(X);
          mass_.push_back(plate.points->point_mass());
        });
    const auto &elements = plate.far->elements();
    for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
      if (elements.mass(node) > 0.)
      {
        nodes_.push_back(node);
        reference_.push_back(elements.mesh().reference_position(node));
        mass_.push_back(elements.mass(node));
      }
    displacement_.setZero(3 * reference_.size());
    load_ = displacement_;
    for (const auto &X : reference_)
      for (int d = 0; d < 3; ++d)
        free_.push_back(!held(X, d));
  }

  std::size_t n_points() const { return points_.size(); }
  std::size_t size() const { return reference_.size(); }
  const Vector3 &reference(const std::size_t i) const { return reference_[i]; }
  double mass(const std::size_t i) const { return mass_[i]; } // [kg]
  Vector3 displacement(const std::size_t i) const { return displacement_.segment<3>(3 * i); }
  double &displacement(const std::size_t i, const int d) { return displacement_[3 * i + d]; }
  double &load(const std::size_t i, const int d) { return load_[3 * i + d]; } // [N]

  /// To the point where the residual has fallen by `tolerance`; returns the number of steps.
  int solve(const double tolerance = 1e-6, const int most = 4000)
  {
    Vector residual = load_ + forces(displacement_), scaled = precondition(residual),
           direction    = scaled;
    double rho          = residual.dot(scaled);
    const double enough = tolerance * tolerance * rho;
    int step            = 0;
    for (; step < most && rho > enough; ++step)
    {
      const double size  = 1e-6 * plate_.spacing / direction.lpNorm<Eigen::Infinity>();
      const Vector image = -forces(size * direction) / size;
      const double alpha = rho / direction.dot(image);
      displacement_ += alpha * direction;
      residual -= alpha * image;
      scaled            = precondition(residual);
      const double next = residual.dot(scaled);
      direction         = scaled + (next / rho) * direction;
      rho               = next;
    }
    // Leaves positions and forces of the solution.
    forces(displacement_);
    return step;
  }

  /// Internal forces, zero where held [N].
  Vector forces(const Vector &u)
  {
    auto &a        = plate_.points->state().arrays;
    auto &elements = plate_.far->elements();
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (int d = 0; d < 3; ++d)
        a.position[d][points_[i]] = reference_[i][d] + u[3 * i + d];
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (int d = 0; d < 3; ++d)
        elements.position()[3 * nodes_[i] + d] = reference_[n + i][d] + u[3 * (n + i) + d];
    plate_.far->lead();
    plate_.evaluate(/*energy=*/false);
    Vector f(u.size());
    for (std::size_t i = 0; i < n; ++i)
      for (int d = 0; d < 3; ++d)
        f[3 * i + d] = free_[3 * i + d] ? a.force[d][points_[i]] : 0.;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (int d = 0; d < 3; ++d)
        f[3 * (n + i) + d] = free_[3 * (n + i) + d] ? elements.force()[3 * nodes_[i] + d] : 0.;
    return f;
  }

  /// Symmetric displacement gradients in the middle of every cell of a plate without coarsening: by
  /// the nodes of an element, by eight neighbouring free points. Calls visit(cell, strain).
  template <class Visitor>
  void for_each_strain(Visitor &&visit) const
  {
    const auto &zone    = *plate_.zone;
    const auto &lattice = plate_.points->lattice();
    const auto &a       = plate_.points->state().arrays;
    const auto &mesh    = plate_.far->elements().mesh();
    for (std::size_t e = 0; e < mesh.elements().size(); ++e)
      if (plate_.far->elements().is_active(static_cast<int>(e)))
        visit(cell_at(lattice, mesh.centre(mesh.elements()[e])),
              symmetric(plate_.far->elements().deformation_gradient(static_cast<int>(e))));
    const int step = std::min(2, zone.points_per_edge());
    const auto &n  = lattice.box().n;
    for (int x = 0; x + 1 < n[0]; x += step)
      for (int y = 0; y + 1 < n[1]; y += step)
        for (int z = 0; z + 1 < n[2]; z += step)
        {
          // A cube of eight points, a cell if these have two along each edge.
          bool free         = true;
          Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
          for (int corner = 0; corner < 8; ++corner)
          {
            const auto p =
                lattice.index(x + (corner & 1), y + ((corner >> 1) & 1), z + (corner >> 2));
            free = free && lattice.free(p);
            for (int d = 0; d < 3; ++d)
              for (int c = 0; c < 3; ++c)
                F(c, d) +=
                    ((corner >> d) & 1 ? 1. : -1.) / (4. * plate_.spacing) * a.position[c][p];
          }
          if (free)
            visit(zone.cell_of(x, y, z), symmetric(F));
        }
  }

private:
  static Eigen::Matrix3d symmetric(const Eigen::Matrix3d &F)
  {
    return 0.5 * (F + F.transpose()) - Eigen::Matrix3d::Identity();
  }

  Vector precondition(const Vector &residual) const
  {
    Vector result(residual.size());
    for (Eigen::Index i = 0; i < residual.size(); ++i)
      result[i] = free_[i] ? residual[i] / mass_[i / 3] : 0.;
    return result;
  }

  PlateModel &plate_;
  std::vector<std::ptrdiff_t> points_;
  std::vector<int> nodes_;
  std::vector<Vector3> reference_; // [m]
  std::vector<double> mass_;
  std::vector<char> free_;
  Vector displacement_, load_;
};
} // namespace ricochet::tests
