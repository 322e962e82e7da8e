// SPDX-License-Identifier: LGPL-2.1-or-later
// Relaxing peridynamics as it stands in the papers (Mitchell 2011): every directed bond has its own
// back-extension, which it updates from two extensions that it remembers. The oracle of the
// lattice's history, which keeps one number per undirected bond.
#pragma once

#include "ricochet/materials/relaxation.h"
#include "support/reference_family.h"

namespace ricochet::tests
{
class RelaxingFamilies
{
public:
  RelaxingFamilies(ReferenceFamilies &families, const RelaxationSeries &series, const double dt,
                   const double bulk_modulus, const double shear_modulus) :
    families_(families),
    series_(series), dt_(dt), K_(bulk_modulus), mu_(shear_modulus)
  {
    for (const auto &neighbours : families.neighbours)
      memory_.push_back(std::vector<Memory>(neighbours.size(),
                                            {0., std::vector<double>(series.size(), 0.), 0., {}}));
    for (auto &family : memory_)
      for (auto &bond : family)
        bond.deviatoric_back = bond.back;
  }

  /// One step to the present positions, forces included. Bonds that are not intact any more count
  /// neither in theta nor in theta_b.
  void step()
  {
    families_.evaluate(); // theta
    const std::size_t n = families_.position.size();
    force.assign(n, Vector3::Zero());
    std::vector<std::vector<double>> theta_back(n, std::vector<double>(series_.size(), 0.));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t b = 0; b < memory_[i].size(); ++b)
      {
        const auto &bond = families_.neighbours[i][b];
        auto &memory     = memory_[i][b];
        const double e   = extension(i, bond);
        update(memory.back, memory.extension, e);
        memory.extension = e;
        const double deviatoric =
            e - families_.dilatation[i] * bond.constants.length / 3.; // directed: theta of i
        update(memory.deviatoric_back, memory.deviatoric, deviatoric);
        memory.deviatoric = deviatoric;
        if (bond.intact)
          for (std::size_t k = 0; k < series_.size(); ++k)
            theta_back[i][k] += bond.constants.dilatation * memory.back[k];
      }

    largest_difference = largest_back = 0.;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t b = 0; b < memory_[i].size(); ++b)
      {
        const auto &bond = families_.neighbours[i][b];
        if (!bond.intact)
          continue;
        const auto &memory       = memory_[i][b];
        // The directed half of t = V^2 omega/m [3 K theta |xi| + 15 sum_k mu_k (e_d - e_d,b)], i's.
        const double per_modulus = bond.constants.extension / (30. * mu_);
        double t                 = 3. * K_ * families_.dilatation[i] * bond.constants.length;
        double shear             = memory.deviatoric;
        for (std::size_t k = 0; k < series_.size(); ++k)
        {
          const double back = memory.back[k] - theta_back[i][k] * bond.constants.length / 3.;
          largest_difference =
              std::max(largest_difference, std::abs(back - memory.deviatoric_back[k]));
          largest_back = std::max(largest_back, std::abs(back));
          shear -= series_[k].share * back;
        }
        t = per_modulus * (t + 15. * mu_ * shear);
        const Vector3 direction =
            (families_.position[bond.point] - families_.position[i]).normalized();
        force[i] += t * direction;
        force[bond.point] -= t * direction;
      }
  }

  std::vector<Vector3> force; // [N]
  /// Between the back-extension of the directed deviatoric extension, updated by itself, and what
  /// follows from undirected ones; equal as long as no bond breaks [m].
  double largest_difference = 0., largest_back = 0.;

private:
  struct Memory
  {
    double extension; // one step ago [m]
    std::vector<double> back;
    double deviatoric;
    std::vector<double> deviatoric_back;
  };

  double extension(const std::size_t i, const ReferenceFamilies::Neighbour &bond) const
  {
    return (families_.position[bond.point] - families_.position[i]).norm() - bond.constants.length;
  }

  /// Mitchell's recurrence as printed.
  void update(std::vector<double> &back, const double before, const double now) const
  {
    for (std::size_t k = 0; k < series_.size(); ++k)
    {
      const double theta = series_[k].time, r = std::exp(-dt_ / theta);
      const double beta = 1. - theta / dt_ * (1. - r);
      back[k]           = before * (1. - r) + back[k] * r + beta * (now - before);
    }
  }

  ReferenceFamilies &families_;
  RelaxationSeries series_;
  double dt_, K_, mu_; // [s], [Pa]
  std::vector<std::vector<Memory>> memory_;
};
} // namespace ricochet::tests
