// SPDX-License-Identifier: LGPL-2.1-or-later
#include "skin_stress.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ricochet
{
namespace
{
/// Faces of the unit cube by their corners, x + 2 y + 4 z.
constexpr int cube_faces[6][4] = {{0, 2, 4, 6}, {1, 3, 5, 7}, {0, 1, 4, 5},
                                  {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}};

std::array<int, 4> sorted(std::array<int, 4> nodes)
{
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// 2 mu times the deviator of the element's mean strain.
Eigen::Matrix3d deviator_of(const HexahedralBody &mesh, const int cell,
                            const std::vector<double> &displacement)
{
  const CellIntegrals sum = integrals(mesh.solid(), cell);
  Eigen::Matrix3d H       = Eigen::Matrix3d::Zero(); // du/dX
  for (int a = 0; a < 8; ++a)
    H += Eigen::Map<const Vector3>(displacement.data() + 3 * mesh.solid().cells[cell][a]) *
         sum.gradient.row(a) / sum.volume;
  const Eigen::Matrix3d strain = 0.5 * (H + H.transpose());
  return 2. * mesh.material().shear_modulus *
         (strain - strain.trace() / 3. * Eigen::Matrix3d::Identity());
}
} // namespace

SkinStress::SkinStress(const HexahedralBody &mesh, const Skin &skin) :
  stress_(6 * skin.faces.size(), 0)
{
  std::map<std::array<int, 4>, int> cell_of; // a face inside belongs to two, one of the skin to one
  for (int cell = 0; cell < static_cast<int>(mesh.solid().cells.size()); ++cell)
    for (const auto &face : cube_faces)
    {
      std::array<int, 4> nodes;
      for (int i = 0; i < 4; ++i)
        nodes[i] = mesh.solid().cells[cell][face[i]];
      cell_of[sorted(nodes)] = cell;
    }
  for (const auto &quad : skin.faces)
  {
    std::array<int, 4> nodes;
    for (int i = 0; i < 4; ++i)
      nodes[i] = skin.mesh_nodes[quad[i]];
    cells_.push_back(cell_of.at(sorted(nodes)));
  }
}

void SkinStress::set_modes(const HexahedralBody &mesh, const FreeModes &modes, const int n)
{
  stress_.resize(6 * cells_.size(), n);
  for (std::size_t face = 0; face < cells_.size(); ++face)
    for (int k = 0; k < n; ++k)
    {
      const Eigen::Matrix3d s =
          deviator_of(mesh, cells_[face], modes.shape[k]) / std::sqrt(mesh.multiplicity());
      stress_.block<6, 1>(6 * face, k) << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(0, 2), s(1, 2);
    }
}

std::vector<double> SkinStress::von_mises(const Eigen::VectorXd &amplitudes) const
{
  std::vector<double> result(cells_.size(), 0.);
  if (stress_.cols() == 0)
    return result;
  const Eigen::VectorXd s = stress_ * amplitudes;
  for (std::size_t face = 0; face < cells_.size(); ++face)
    result[face] = std::sqrt(1.5 * (s.segment<3>(6 * face).squaredNorm() +
                                    2. * s.segment<3>(6 * face + 3).squaredNorm()));
  return result;
}
} // namespace ricochet
