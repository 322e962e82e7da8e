// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/coupled_plate.h"

#include "plate_elements.h"

namespace ricochet
{
CoupledPlate::CoupledPlate(const MPI_Comm communicator, std::unique_ptr<Zone> zone,
                           std::unique_ptr<PeridynamicBody> points,
                           const CoupledPlateOptions &options) :
  communicator_(communicator),
  zone_(std::move(zone)), points_(std::move(points)), options_(options),
  elements_(communicator, mesh_box(*points_, *zone_, options), material_of(*points_),
            element_options(*points_, *zone_, options)),
  calibration_(communicator, *points_, elements_,
               {elements_.material().bulk_modulus,
                elements_.material().shear_modulus * (1. - relaxing_share(*points_))},
               options.coupling.calibration)
{
  if (!elements_.material().relaxation.empty())
    shear_calibration_ = std::make_unique<Calibration>(
        communicator, *points_, elements_, ElasticModuli{0., elements_.material().shear_modulus},
        options.coupling.calibration);
  if (options_.absorbing_edges)
    elements_.absorb_at({true, true, !points_->lattice().box().mirror_y, true, false, false});
  build_interface();
  interpolate_to_slaved_points();
}

void CoupledPlate::interpolate_to_slaved_points()
{
  elements_.update_ghosts();
  slaved_.interpolate_to_slaved_points(elements_, points_->state());
}

void CoupledPlate::start_relaxation(const double dt)
{
  points_->start_relaxation(dt);
  elements_.start_relaxation(dt);
}

void CoupledPlate::compute_internal_forces(const ForceRequest &request)
{
  points_->compute_internal_forces(request);
  elements_.compute_internal_forces(request);
}

void CoupledPlate::distribute_slaved_forces()
{
  if (options_.coupling.method == CouplingMethod::force_blend)
    blend_forces();
  else
    slaved_.add_transposed(points_->state(), elements_.force());
}

void CoupledPlate::complete_forces()
{
  distribute_slaved_forces();
  elements_.complete_forces();
}

void CoupledPlate::advance(const double kick, const double drift)
{
  points_->advance(kick, drift);
  elements_.advance(kick, drift);
  interpolate_to_slaved_points();
}

void CoupledPlate::rest()
{
  points_->rest();
  elements_.rest();
  interpolate_to_slaved_points();
  points_->update_ghosts();
}

void CoupledPlate::blend_forces()
{
  bond_force_.assign(elements_.force().size(), 0.);
  slaved_.add_transposed(points_->state(), bond_force_);
  for (std::size_t i = 0; i < 3 * bond_share_.size(); ++i)
  {
    const double share   = bond_share_[i / 3];
    elements_.force()[i] = (1. - share) * elements_.force()[i] + share * bond_force_[i];
  }
}

Energies CoupledPlate::energies(const double dt) const
{
  auto energies = points_->energies(dt);
  energies += elements_.energies(dt);
  return energies;
}

Momenta CoupledPlate::momenta() const
{
  auto momenta = points_->momenta();
  momenta += elements_.momenta();
  return momenta;
}

std::string CoupledPlate::first_not_finite() const
{
  const auto found = points_->first_not_finite();
  return found.empty() ? elements_.first_not_finite() : found;
}
} // namespace ricochet
