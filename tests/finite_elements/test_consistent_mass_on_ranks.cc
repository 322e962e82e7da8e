// SPDX-License-Identifier: LGPL-2.1-or-later
// The momentum under the consistent mass on several ranks and on one. The iteration takes no sums
// over ranks; what is left are the sums at nodes that several ranks' elements share.
#include "finite_elements/consistent_mass.h"
#include "support/element_body.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
std::map<std::array<long, 3>, Vector3> momenta(const MPI_Comm communicator, double &largest)
{
  const HexMesh mesh(communicator, refined_box());
  const auto lumped = lumped_mass(mesh, 1190., std::vector<char>(mesh.elements().size(), 1), {});
  std::vector<int> elements;
  for (std::size_t e = 0; e < mesh.elements().size(); ++e)
    if (mesh.centre(mesh.elements()[e]).x() < 1e-3)
      elements.push_back(static_cast<int>(e));
  ConsistentMass mass(communicator, mesh, lumped, 1190., elements, 2);
  std::vector<double> velocity(mesh.reference().size(), 0.);
  for (int node = 0; node < mesh.n_owned_nodes(); ++node)
    if (lumped.mass[node] > 0.)
      set(velocity, node, noise_at(mesh.reference_position(node), 1e-3));
  mass.find_momentum(velocity);
  std::map<std::array<long, 3>, Vector3> result;
  largest = 0.;
  for (std::size_t k = 0; k < mass.nodes().size(); ++k)
  {
    const Vector3 X = mesh.reference_position(mass.nodes()[k]) / 0.25e-3;
    result[{std::lround(X.x()), std::lround(X.y()), std::lround(X.z())}] =
        at(mass.momentum(), static_cast<int>(k));
    largest = std::max(largest, at(mass.momentum(), static_cast<int>(k)).cwiseAbs().maxCoeff());
  }
  return result;
}

TEST(ConsistentMassOnRanks, IsThatOfOneRankToTheRoundingOfSharedNodes)
{
  double largest = 0., ignored = 0.;
  const auto alone = momenta(MPI_COMM_SELF, largest), together = momenta(MPI_COMM_WORLD, ignored);
  double worst = 0.;
  for (const auto &[place, p] : together)
    worst = std::max(worst, (p - alone.at(place)).cwiseAbs().maxCoeff());
  MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  int n = static_cast<int>(together.size()), n_ranks;
  MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  EXPECT_EQ(n, static_cast<int>(alone.size()));
  std::printf("largest difference %.1e of the largest momentum\n", worst / largest);
  EXPECT_LE(worst, n_ranks == 1 ? 0. : 1e-15 * largest);
}
} // namespace
} // namespace ricochet::tests
