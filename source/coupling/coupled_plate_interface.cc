// SPDX-License-Identifier: LGPL-2.1-or-later
// Where points end and elements begin: what makes a CoupledPlate one body.
#include "plate_elements.h"
#include "ricochet/base/voigt.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
void CoupledPlate::build_interface()
{
  switch (options_.coupling.method)
  {
    case CouplingMethod::calibrated_energy_blend:
      elements_.set_stiffness(calibrated_stiffness());
      break;
    case CouplingMethod::energy_blend:
      elements_.set_stiffness(blended_stiffness());
      break;
    case CouplingMethod::force_blend:
    case CouplingMethod::none:
      break;
  }

  if (options_.coupling.correct_mass)
    correct_mass_of_pad();
  find_slaved_nodes();

  if (options_.coupling.method == CouplingMethod::force_blend)
    find_bond_shares();
}

/// Elements of the pad act as if their mass sat in the points.
void CoupledPlate::correct_mass_of_pad()
{
  const auto &mesh  = elements_.mesh();
  const double cell = zone_->points_per_edge() * points_->lattice().box().spacing;
  std::vector<int> pad;
  for (std::size_t e = 0; e < mesh.elements().size(); ++e)
  {
    const auto &element = mesh.elements()[e];
    if (element.edge > 1.5 * cell)
      continue;
    const int layer = zone_->layer(cell_at(points_->lattice(), mesh.centre(element)));
    if (layer > 0 && layer <= zone_->pad_layers())
      pad.push_back(static_cast<int>(e));
  }
  elements_.set_consistent_mass(pad, zone_->points_per_edge());
}

/// Of the force on each owned node, by its distance from the zone.
void CoupledPlate::find_bond_shares()
{
  const auto &mesh  = elements_.mesh();
  const auto &box   = points_->lattice().box();
  const double cell = zone_->points_per_edge() * box.spacing;
  const int width   = cells_in(options_.coupling.blend_width, points_->lattice().stencil(),
                               zone_->points_per_edge());
  bond_share_.clear();
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
  {
    // Layer of the nearest cell around the node: its distance from the zone in cells.
    const Vector3 at = (mesh.reference_position(node) - box.corner) / cell;
    int distance     = std::numeric_limits<int>::max();
    for (int corner = 0; corner < 8; ++corner)
    {
      Zone::Cell around;
      for (int d = 0; d < 3; ++d)
        around[d] = static_cast<int>(std::lround(at[d])) - ((corner >> d) & 1);
      if (zone_->contains(around))
        distance = std::min(distance, zone_->layer(around));
    }
    bond_share_.push_back(blend(options_.coupling.blend, double(distance) / width));
  }
}

/// Finds the nodes that slaved points follow.
void CoupledPlate::find_slaved_nodes()
{
  slaved_ = SlavedPoints(communicator_, elements_, points_->lattice(),
                         [&](const Zone::Cell &at)
                         { return zone_->is_slaved(at) || zone_->has_contact(at); });
}

CalibrationReport CoupledPlate::calibration() const
{
  CalibrationReport report = calibration_.report();
  if (shear_calibration_)
  {
    const auto &shear          = shear_calibration_->report();
    report.ghost_before        = std::max(report.ghost_before, shear.ghost_before);
    report.ghost_after         = std::max(report.ghost_after, shear.ghost_after);
    report.smallest_eigenvalue = std::min(report.smallest_eigenvalue, shear.smallest_eigenvalue);
    report.n_iterations += shear.n_iterations;
  }
  return report;
}

std::vector<ElementStiffness> CoupledPlate::calibrated_stiffness()
{
  auto stiffness = calibration_.find();
  if (!shear_calibration_)
    return stiffness;
  // What is left in the end, and what relaxes: neither is negative, so nothing in between is.
  const auto shear   = shear_calibration_->find();
  const double share = relaxing_share(*points_);
  for (std::size_t i = 0; i < stiffness.size(); ++i)
  {
    stiffness[i].shear = shear[i].tensors;
    for (std::size_t g = 0; g < shear[i].tensors.size(); ++g)
      for (int k = 0; k < HexTensors::n_entries; ++k)
        stiffness[i].tensors[g][k] += share * shear[i].tensors[g][k];
  }
  return stiffness;
}

/// 1 minus the mean weight of the points in an element, times the material's stiffness.
std::vector<ElementStiffness> CoupledPlate::blended_stiffness() const
{
  const auto &mesh        = elements_.mesh();
  const auto &box         = points_->lattice().box();
  const int n             = zone_->points_per_edge();
  const double cell       = n * box.spacing;
  const auto &material    = elements_.material();
  const double tetragonal = material.anisotropy.tetragonal * material.shear_modulus,
               diagonal   = material.anisotropy.diagonal * material.shear_modulus;
  std::vector<ElementStiffness> stiffness;
  for (std::size_t e = 0; e < mesh.elements().size(); ++e)
  {
    const auto &element = mesh.elements()[e];
    const auto at       = cell_at(points_->lattice(), mesh.centre(element));
    if (element.edge > 1.5 * cell || !zone_->is_slaved(at))
      continue;
    double share = 1.;
    for (int z = n * at[2]; z < n * (at[2] + 1); ++z)
      for (int y = n * at[1]; y < n * (at[1] + 1); ++y)
        for (int x = n * at[0]; x < n * (at[0] + 1); ++x)
          share -= zone_->weight(x, y, z) / (n * n * n);
    ElementStiffness own{static_cast<int>(e), {}};
    const auto cubic = [&](const double first)
    {
      std::array<double, HexTensors::n_entries> tensor;
      for (int i = 0, k = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j, ++k)
          tensor[k] = share * ((j < 3 ? first : 0.) +
                               (i == j ? (voigt::is_shear(i) ? diagonal : 2. * tetragonal) : 0.));
      return tensor;
    };
    own.tensors.fill(cubic(material.bulk_modulus - 2. / 3. * tetragonal));
    own.shear.fill(cubic(-2. / 3. * tetragonal));
    stiffness.push_back(own);
  }
  return stiffness;
}
} // namespace ricochet
