// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plate_builder.h"

#include "plate_cutouts.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/simulation/plate_size.h"
#include "ricochet/simulation/plate_zone.h"

#include <cmath>

namespace ricochet
{
namespace
{
/// Lattice of each plate; the first one's upper face is z = 0.
std::vector<Lattice::Box> boxes_of(const Scene &scene)
{
  std::vector<Lattice::Box> boxes;
  double top = 0.;
  for (const auto &plate : scene.plates)
  {
    Lattice::Box box;
    box.spacing  = plate.spacing;
    box.mirror_y = scene.symmetric;
    box.n        = lattice_points(scene, plate);
    top -= boxes.empty() ? 0. : plate.gap;
    const double thickness = box.n[2] * plate.spacing;
    box.corner = {0., scene.symmetric ? 0. : -0.5 * box.n[1] * plate.spacing, top - thickness};
    top -= thickness;
    boxes.push_back(box);
  }
  return boxes;
}

PeridynamicMaterial bonds_of(const Scene &scene, const MaterialParameters &material,
                             const Stencil &stencil)
{
  return {&bond_law(material.bond_model),
          material.density,
          material.bulk_modulus,
          material.shear_modulus,
          critical_stretch(material, stencil),
          relaxing_within(material.relaxation, scene.time.end_time),
          material.history_precision,
          material.cracks_push,
          material.flow,
          material.parting_extension};
}

Plate build_plate(const MPI_Comm communicator, const Scene &scene, const std::size_t number,
                  const Lattice::Box &box)
{
  const auto &plate = scene.plates[number];
  const Stencil stencil =
      make_stencil(plate.spacing, plate.horizon_ratio, plate.influence_function);
  const auto bonds = bonds_of(scene, material_of(scene, plate), stencil);
  auto zone        = plate_zone(scene, plate, box, stencil);
  const auto n     = static_cast<unsigned int>(number) + 1;
  auto points =
      std::make_unique<PeridynamicBody>(communicator, static_cast<int>(number), box, stencil, bonds,
                                        mask_of(plate.cutouts, box, n), nullptr, zone.zone.get());
  sever_cracks(plate.cutouts, *points, n);
  auto *const seen = points.get();
  if (zone.zone == nullptr)
    return {std::move(points), seen, nullptr, zone.reason};
  // Contact with a deformable projectile remembers points.
  bool all_rigid = true;
  for (std::size_t i = 0; i < scene.n_projectiles(); ++i)
    all_rigid = all_rigid && scene.projectile_at(i).model == ProjectileModel::rigid;
  const AdaptiveZone::Parameters growth{scene.zone.conversion_stretch * bonds.critical_stretch,
                                        scene.zone.adaptive, all_rigid};
  auto coupled =
      std::make_unique<AdaptivePlate>(communicator, std::move(zone.zone), std::move(points),
                                      zone.options, growth, zone.growth_ahead);
  auto *const adaptive = coupled.get();
  return {std::move(coupled), seen, adaptive, zone.reason};
}
} // namespace

const MaterialParameters &material_of(const Scene &scene, const PlateParameters &plate)
{
  for (const auto &material : scene.materials)
    if (material.name == plate.material)
      return material;
  throw InputError("There is no material '" + plate.material + "'.");
}

double critical_stretch(const MaterialParameters &material, const Stencil &stencil)
{
  if (material.critical_stretch > 0.)
    return material.critical_stretch;
  return std::sqrt(material.energy_release / fracture_energy_per_squared_stretch(
                                                 stencil, bond_law(material.bond_model),
                                                 material.bulk_modulus, material.shear_modulus));
}

std::vector<Plate> build_plates(const MPI_Comm communicator, const Scene &scene)
{
  std::vector<Plate> plates;
  const auto boxes = boxes_of(scene);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    plates.push_back(build_plate(communicator, scene, i, boxes[i]));
  return plates;
}
} // namespace ricochet
