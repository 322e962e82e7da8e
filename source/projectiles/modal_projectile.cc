// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modal_projectile.h"

#include "finite_element_projectile.h"
#include "ricochet/base/number_text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
/// Of the largest frequency that the plates' step allows: modes below are computed. There the
/// leapfrog scheme, whose step is 2 s/omega_plates with a safety factor s < 1, is wrong in a
/// frequency by (omega dt)^2/24 < 4 %, and contact may add three times the mode's own squared
/// frequency before it costs time step.
constexpr double resolved_share = 0.5;
} // namespace

ModalProjectile::ModalProjectile(const MPI_Comm communicator, const Scene &scene,
                                 const HexSolid &mesh, const Motion &start, const FrictionLaw &law,
                                 const std::vector<PlateContact> &plates) :
  DeformableProjectile(communicator, scene, Skin(mesh, scene.symmetric).nodes,
                       Skin(mesh, scene.symmetric).faces, law, plates),
  mesh_(mesh, elastic_material(scene, mesh), scene.symmetric), skin_(mesh, scene.symmetric),
  elastic_(body(), mesh_, skin_.mesh_nodes, start), stress_(mesh_, skin_),
  finder_(communicator, mesh_, pushes_on_nose()), n_asked_(scene.projectile.modes)
{
  measure_skin(plates);
  begin_motion();
}

/// A newton along the axis and one across, shared out over the nose by its area.
ModeFinder::Loads ModalProjectile::pushes_on_nose() const
{
  std::vector<double> area(mesh_.n_nodes(), 0.);
  double whole = 0.;
  for (const auto &quad : outer_faces(mesh_.solid(), mesh_.mirrored()))
  {
    const auto node = [&](const int i) -> const Vector3 & { return mesh_.solid().nodes[quad[i]]; };
    const Vector3 centre = 0.25 * (node(0) + node(1) + node(2) + node(3));
    if (body().hit(centre).surface != BodyOfRevolution::Surface::nose)
      continue;
    const double size = 0.5 * (node(2) - node(0)).cross(node(3) - node(1)).norm();
    for (const int corner : quad)
      area[corner] += size / 4.;
    whole += mesh_.multiplicity() * size;
  }
  ModeFinder::Loads loads;
  for (int i = 0; i < 2; ++i)
    loads[i].assign(3 * area.size(), 0.);
  for (std::size_t i = 0; i < area.size(); ++i)
    loads[0][3 * i] = loads[1][3 * i + 2] = area[i] / whole;
  return loads;
}

void ModalProjectile::measure_skin(const std::vector<PlateContact> &plates)
{
  normal_.assign(skin_.nodes.size(), Vector3::Zero());
  for (const auto &quad : skin_.faces)
    for (const int node : quad)
      normal_[node] += (skin_.nodes[quad[2]] - skin_.nodes[quad[0]])
                           .cross(skin_.nodes[quad[3]] - skin_.nodes[quad[1]]) /
                       8.;
  double per_area = 0.; // of one layer of points [N/m^3]
  for (const auto &plate : plates)
    per_area = std::max(per_area, plate.parameters.stiffness / std::pow(plate.spacing, 2));
  for (auto &normal : normal_)
  {
    stiffness_.push_back(per_area * normal.norm());
    normal.normalize();
  }
}

int ModalProjectile::n_below(const double squared_frequency) const
{
  const auto &all = found_.modes.squared_frequency;
  return static_cast<int>(std::lower_bound(all.begin(), all.end(), squared_frequency) -
                          all.begin());
}

/// And at least one beyond, if the mesh has so many.
void ModalProjectile::find_modes_below(const double squared_frequency)
{
  const int most = most_free_modes(mesh_);
  for (int n = std::min(16, most);; n = std::min(2 * n, most))
  {
    found_ = finder_.lowest(n);
    if (n == most || n_below(squared_frequency) < n)
      return;
  }
}

void ModalProjectile::resolve(const double squared_frequency)
{
  plates_ = squared_frequency;
  int n   = n_asked_;
  if (n > 0)
    found_ = finder_.lowest(n);
  else
  {
    const double limit = resolved_share * resolved_share * plates_;
    find_modes_below(limit);
    n = n_below(limit);
  }
  for (elastic_.set_modes(found_.modes, n);; elastic_.set_modes(found_.modes, --n))
  {
    squared_frequency_ = elastic_.squared_frequency(stiffness_, normal_);
    if (n_asked_ > 0 || n == 0 || squared_frequency_ <= plates_)
      break;
  }
  stress_.set_modes(mesh_, found_.modes, n);
  begin_motion();
}

void ModalProjectile::advance(const double kick, const double drift)
{
  DeformableProjectile::advance(kick, drift);
  for (const double stress : stress_.von_mises(elastic_.amplitudes()))
    largest_von_mises_ = std::max(largest_von_mises_, stress);
}

SurfaceFrame ModalProjectile::surface() const
{
  SurfaceFrame frame = DeformableProjectile::surface();
  frame.von_mises    = stress_.von_mises(elastic_.amplitudes());
  const auto half    = frame.von_mises;
  if (mesh_.mirrored()) // in the order of the frame's faces
    frame.von_mises.insert(frame.von_mises.end(), half.begin(), half.end());
  return frame;
}

std::vector<double> ModalProjectile::present_velocities(const double kick)
{
  mobility_ = elastic_.mobility_of_loaded();
  return elastic_.velocity_after(kick / 2.);
}

std::string ModalProjectile::parts() const
{
  return std::to_string(elastic_.n_modes()) + " modes of " +
         std::to_string(static_cast<std::size_t>(mesh_.multiplicity()) *
                        mesh_.solid().cells.size()) +
         " hexahedra";
}

std::string ModalProjectile::description() const
{
  const auto in_kHz = [](const double squared)
  { return with_digits(std::sqrt(squared) / (2. * M_PI) / 1e3, 4); };
  const int n = elastic_.n_modes();
  if (n == 0)
    return "  modes        none below " + in_kHz(resolved_share * resolved_share * plates_) +
           " kHz, half of the plates' limit: it is rigid\n";
  std::string text = "  modes        ";
  for (int k = 0; k < n; ++k)
    text += (k == 0        ? ""
             : k % 10 == 0 ? ",\n               "
                           : ", ") +
            in_kHz(found_.modes.squared_frequency[k]);
  text += " kHz; the plates' limit is " + in_kHz(plates_) + " kHz\n";
  const auto loads = pushes_on_nose();
  double left_out[2];
  for (int i = 0; i < 2; ++i)
  {
    double kept = 0.;
    for (int k = 0; k < n; ++k)
    {
      const auto &shape = found_.modes.shape[k];
      double product    = 0.;
      for (std::size_t j = 0; j < shape.size(); ++j)
        product += shape[j] * loads[i][j];
      kept += mesh_.multiplicity() * product * product / found_.modes.squared_frequency[k];
    }
    left_out[i] = 100. * (1. - kept / found_.compliance[i]);
  }
  return text + "  left out     " + with_digits(left_out[0], 2) +
         " % of what a push on the nose along the axis bends, " + with_digits(left_out[1], 2) +
         " % across\n";
}

void ModalProjectile::exchange_state(StateArchive &archive)
{
  DeformableProjectile::exchange_state(archive);
  archive.common("largest von Mises stress", largest_von_mises_);
}
} // namespace ricochet
