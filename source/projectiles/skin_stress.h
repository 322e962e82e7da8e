// SPDX-License-Identifier: LGPL-2.1-or-later
// Stresses in the elements below the surface of a modal projectile: sums of those of its modes, as
// long as strains are small.
#pragma once

#include "ricochet/finite_elements/free_vibration.h"
#include "skin.h"

namespace ricochet
{
class SkinStress
{
public:
  /// None as yet. Each face of the skin has the mean stress of its element.
  SkinStress(const HexahedralBody &mesh, const Skin &skin);

  /// From now on of the first n modes of the mesh.
  void set_modes(const HexahedralBody &mesh, const FreeModes &modes, int n);

  /// Von Mises' stress below each face, with amplitudes as ModalBody has them [Pa].
  std::vector<double> von_mises(const Eigen::VectorXd &amplitudes) const;

private:
  std::vector<int> cells_; // of each face
  Eigen::MatrixXd stress_; // deviator's xx, yy, zz, xy, xz, yz of each face by modes
};
} // namespace ricochet
