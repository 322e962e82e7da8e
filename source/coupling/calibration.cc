// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/calibration.h"

#include "calibrated_elements.h"
#include "stiffness_least_squares.h"

#include "ricochet/base/exchange.h"
#include "ricochet/base/phase_clock.h"
#include "ricochet/base/voigt.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
/// What a rank has found and tells the others.
struct Finding
{
  Zone::Cell cell; // the last of those with the same surroundings counts, on any number of ranks
  GaussPointTensors tensors;
};

/// Minus the forces of the cells of the zone as if they were elements, at the nodes of those around
/// it.
void subtract_free_cells(const CalibratedElements &system, const Matrix6 &solid,
                         NodalForces &forces)
{
  const Zone &zone = system.zone();
  const auto &mesh = system.mesh();
  for (std::size_t i = 0; i < forces.size(); ++i)
  {
    const int node = system.nodes()[i];
    if (node >= mesh.n_owned_nodes())
      continue;
    const Vector3 at =
        (mesh.reference_position(node) - system.lattice().box().corner) / system.edge();
    for (int corner = 0; corner < 8; ++corner)
    {
      // The node is this corner of the cell.
      Zone::Cell cell;
      for (int d = 0; d < 3; ++d)
        cell[d] = static_cast<int>(std::lround(at[d])) - ((corner >> d) & 1);
      if (!zone.contains(cell) || !zone.is_free(cell))
        continue;
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
        {
          // f = -sigma s h^2/4
          const double sign = (corner >> d) & 1 ? 0.25 : -0.25;
          for (int k = 0; k < n_unit_strains; ++k)
            forces[i][c][k] += sign * solid(voigt::number[c][d], k);
        }
    }
  }
}
} // namespace

Calibration::Calibration(const MPI_Comm communicator, const PeridynamicBody &points,
                         const FiniteElementBody &elements, const ElasticModuli &moduli,
                         const CalibrationOptions &options) :
  communicator_(communicator),
  points_(points), elements_(elements), moduli_(moduli), options_(options), forces_(points, moduli)
{
}

std::vector<ElementStiffness> Calibration::find()
{
  const PhaseClock::Work work(Phase::calibration);
  const CalibratedElements system(communicator_, points_.lattice(), elements_.mesh(),
                                  options_.tolerance);
  StiffnessLeastSquares::Start start;
  find_start(system, start.tensors, start.kept);
  start.residual = residual_of(system, start.tensors);
  StiffnessLeastSquares problem(communicator_, system, std::move(start), options_);
  problem.solve(report_);
  remember(system, problem.tensors());

  const double modulus = moduli_.bulk + 4. / 3. * moduli_.shear;
  std::vector<ElementStiffness> stiffness(system.elements().size());
  for (std::size_t i = 0; i < stiffness.size(); ++i)
  {
    stiffness[i].element = system.elements()[i].number;
    for (int g = 0; g < 8; ++g)
      for (int k = 0; k < HexTensors::n_entries; ++k)
        stiffness[i].tensors[g][k] = modulus * problem.tensors()[i][g][k];
  }
  return stiffness;
}

/// The best tensors known for each element; kept are those of cells whose surroundings have not
/// changed.
void Calibration::find_start(const CalibratedElements &system,
                             std::vector<GaussPointTensors> &tensors, std::vector<char> &kept)
{
  const Zone &zone    = system.zone();
  const Matrix6 solid = cubic_stiffness(moduli_, elements_.material().anisotropy);
  for (const auto &element : system.elements())
  {
    auto &own = tensors.emplace_back();
    kept.push_back(0);
    if (const auto *const present = kept_tensors(zone.number(element.cell), element.pattern))
    {
      own         = *present;
      kept.back() = 1;
    }
    else if (const auto same = found_.find(element.pattern); same != found_.end())
      own = same->second;
    else if (const auto near = similar_.find(pattern(element.cell, /*alike=*/true));
             near != similar_.end())
      own = near->second;
    else
    {
      const double bonds = forces_.of(element.cell, element.pattern).stress_share;
      own.fill(packed(std::clamp(1. - bonds, 0., 1.) * solid));
    }
  }
}

/// Of a cell that has kept its surroundings since the last find(), otherwise null.
const GaussPointTensors *Calibration::kept_tensors(const std::size_t cell,
                                                   const CellPattern &pattern) const
{
  const auto present = present_.find(cell);
  const bool is_kept = present != present_.end() && present->second.pattern == pattern;
  return is_kept ? &present->second.tensors : nullptr;
}

/// Bonds plus what the elements have less than in full, minus the elements that the cells of the
/// zone would be.
NodalForces Calibration::residual_of(const CalibratedElements &system,
                                     const std::vector<GaussPointTensors> &tensors)
{
  NodalForces residual(system.nodes().size());
  const Matrix6 solid        = cubic_stiffness(moduli_, elements_.material().anisotropy);
  const double modulus       = moduli_.bulk + 4. / 3. * moduli_.shear;
  const double unit          = 1. / (modulus * system.edge() * system.edge());
  const StiffnessTensor full = packed(solid);
  subtract_free_cells(system, solid, residual);
  // An element adds once: what its own terms are added up to must not depend on its neighbours.
  NodalForces own(8);
  const std::array<int, 8> own_corners{0, 1, 2, 3, 4, 5, 6, 7};
  for (std::size_t i = 0; i < tensors.size(); ++i)
  {
    const auto &element = system.elements()[i];
    const auto &bonds   = forces_.of(element.cell, element.pattern);
    for (int a = 0; a < 8; ++a)
      for (int c = 0; c < 3; ++c)
        own[a][c] = unit * bonds.corner[a][c];
    GaussPointTensors less = tensors[i];
    for (auto &tensor : less)
      add(-1., full, tensor);
    add_cube_forces(less, own_corners, own);
    for (int a = 0; a < 8; ++a)
      for (int c = 0; c < 3; ++c)
        residual[element.corner[a]][c] += own[a][c];
  }
  system.complete(residual);
  return residual;
}

CellPattern Calibration::pattern(const Zone::Cell &cell, const bool alike) const
{
  const Lattice &lattice = points_.lattice();
  return cell_pattern(*lattice.zone(), cell, lattice.stencil(), lattice.box().mirror_y, alike);
}

void Calibration::remember(const CalibratedElements &system,
                           const std::vector<GaussPointTensors> &tensors)
{
  const Zone &zone = system.zone();
  std::vector<Finding> own;
  decltype(present_) present;
  for (std::size_t i = 0; i < tensors.size(); ++i)
  {
    const auto &element = system.elements()[i];
    const auto number   = zone.number(element.cell);
    if (kept_tensors(number, element.pattern) == nullptr)
      own.push_back({element.cell, tensors[i]});
    present[number] = {element.pattern, tensors[i]};
  }
  present_.swap(present);
  int n_ranks;
  MPI_Comm_size(communicator_, &n_ranks);
  auto all = joined(exchange_lists(communicator_, std::vector<std::vector<Finding>>(n_ranks, own)));
  std::sort(all.begin(), all.end(),
            [&](const Finding &a, const Finding &b)
            { return zone.number(a.cell) < zone.number(b.cell); });
  // All ranks know the zone, and therefore the patterns.
  for (const auto &finding : all)
  {
    found_.insert_or_assign(pattern(finding.cell, /*alike=*/false), finding.tensors);
    similar_.insert_or_assign(pattern(finding.cell, /*alike=*/true), finding.tensors);
  }
}
} // namespace ricochet
