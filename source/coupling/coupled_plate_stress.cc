// SPDX-License-Identifier: LGPL-2.1-or-later
// What the points of a CoupledPlate feel that follow its elements.
#include "nodal_means.h"
#include "ricochet/base/voigt.h"
#include "ricochet/coupling/coupled_plate.h"
#include "ricochet/finite_elements/element_stress.h"

namespace ricochet
{
std::vector<StressState> CoupledPlate::slaved_stress()
{
  // Stress in Voigt's order, dilatation, energy density, and a place to spare.
  constexpr int n_triples = 3, dilatation = voigt::n, energy = voigt::n + 1;
  const auto nodal =
      nodal_means(elements_, {n_triples,
                              [&](const int element, double *const values)
                              {
                                const auto state = element_stress(elements_, element);
                                for (int i = 0; i < voigt::n; ++i)
                                  values[i] = state.stress(voigt::row[i], voigt::column[i]);
                                values[dilatation] = state.dilatation;
                                values[energy]     = state.energy_density;
                                values[energy + 1] = 0.;
                              },
                              is_odd_in_mirror});
  std::vector<double> fields[3 * n_triples];
  for (auto &field : fields)
    field.assign(points_->lattice().size(), 0.);
  for (int f = 0; f < n_triples; ++f)
  {
    double *const triple[3] = {fields[3 * f].data(), fields[3 * f + 1].data(),
                               fields[3 * f + 2].data()};
    slaved_.interpolate(nodal[f], triple);
  }
  std::vector<StressState> states(points_->lattice().size());
  for (std::size_t p = 0; p < states.size(); ++p)
  {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        states[p].stress(i, j) = fields[voigt::number[i][j]][p];
    states[p].dilatation     = fields[dilatation][p];
    states[p].energy_density = fields[energy][p];
  }
  return states;
}
} // namespace ricochet
