// SPDX-License-Identifier: LGPL-2.1-or-later
// The only file that sees Trilinos. Everything is made on MPI_COMM_SELF.
#include "ricochet/finite_elements/free_vibration.h"

#include "free_components.h"
#include "level_cholesky.h"
#include "ricochet/base/elastic_constants.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/noise.h"

#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <AnasaziEpetraAdapter.hpp>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_MultiVector.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet
{
namespace
{
using Dense = Eigen::Map<Eigen::MatrixXd>;

/// The columns of an Epetra vector, which is serial, as a matrix.
Dense columns_of(Epetra_MultiVector &x)
{
  return {x.Values(), x.MyLength(), x.NumVectors()};
}

SparseRows rows_of(const Epetra_CrsMatrix &matrix)
{
  SparseRows rows{{0}, {}, {}};
  for (int row = 0; row < matrix.NumMyRows(); ++row)
  {
    int n = 0, *columns = nullptr;
    double *values = nullptr;
    matrix.ExtractMyRowView(row, n, values, columns);
    rows.columns.insert(rows.columns.end(), columns, columns + n);
    rows.values.insert(rows.values.end(), values, values + n);
    rows.starts.push_back(static_cast<int>(rows.columns.size()));
  }
  return rows;
}

/// (A + sigma)^-1, as Anasazi asks for it.
class ShiftedInverse : public Epetra_Operator
{
public:
  explicit ShiftedInverse(const Epetra_CrsMatrix &matrix) :
    matrix_(matrix), factors_(rows_of(matrix))
  {
  }

  int Apply(const Epetra_MultiVector &b, Epetra_MultiVector &x) const override
  {
    // Vectors that Anasazi shows need not lie side by side.
    Eigen::MatrixXd columns(b.MyLength(), b.NumVectors());
    for (int k = 0; k < b.NumVectors(); ++k)
      std::copy_n(b[k], b.MyLength(), columns.col(k).data());
    factors_.solve(columns);
    for (int k = 0; k < b.NumVectors(); ++k)
      std::copy_n(columns.col(k).data(), b.MyLength(), x[k]);
    return 0;
  }
  int ApplyInverse(const Epetra_MultiVector &x, Epetra_MultiVector &b) const override
  {
    return matrix_.Apply(x, b);
  }
  int SetUseTranspose(bool) override { return -1; }
  double NormInf() const override { return -1.; }
  const char *Label() const override { return "(A + sigma)^-1"; }
  bool UseTranspose() const override { return false; }
  bool HasNormInf() const override { return false; }
  const Epetra_Comm &Comm() const override { return matrix_.Comm(); }
  const Epetra_Map &OperatorDomainMap() const override { return matrix_.OperatorDomainMap(); }
  const Epetra_Map &OperatorRangeMap() const override { return matrix_.OperatorRangeMap(); }

private:
  const Epetra_CrsMatrix &matrix_;
  LevelCholesky factors_;
};

} // namespace

int most_free_modes(const HexahedralBody &body)
{
  return degrees_of_freedom(body) / 3;
}

struct FreeVibration::System
{
  const HexahedralBody &body;
  std::vector<int> number;   // of each component among the free ones, or -1
  Eigen::VectorXd root_mass; // of each free one [kg^1/2]
  double sigma; // the shift: (c_0/L)^2, below the first axial mode's (pi c_0/L)^2 [1/s^2]
  Epetra_MpiComm communicator;
  Epetra_Map map;
  Epetra_CrsMatrix matrix;                // A/sigma + 1
  Teuchos::RCP<Epetra_MultiVector> rigid; // rigid modes times M^1/2, orthonormal
  std::unique_ptr<ShiftedInverse> inverse;

  explicit System(const HexahedralBody &the_body);
  void find_pattern();
  void assemble();
  void find_rigid_modes();
  /// Takes rigid motion out of each column.
  void deflate(Dense x) const;
  /// Modes from vectors that span their space: exact squares of frequencies, in order.
  FreeModes modes_from(const Eigen::MatrixXd &span) const;
  /// x/M^1/2, three numbers per node.
  std::vector<double> on_nodes(const Eigen::VectorXd &x) const;
};

FreeVibration::System::System(const HexahedralBody &the_body) :
  body(the_body), number(number_free(body)),
  root_mass(1 + *std::max_element(number.begin(), number.end())), communicator(MPI_COMM_SELF),
  map(static_cast<int>(root_mass.size()), 0, communicator), matrix(Copy, map, 0)
{
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0)
      root_mass[number[i]] = 1. / std::sqrt(body.inverse_mass(static_cast<int>(i)));
  const auto &material = body.material();
  const double E       = youngs_modulus(material.bulk_modulus, material.shear_modulus);
  Eigen::AlignedBox3d box;
  for (const auto &X : body.solid().nodes)
    box.extend(X);
  sigma = E / material.density / box.sizes().squaredNorm();
  if (!(sigma > 0.))
    throw InputError("The projectile has no stiffness: nothing vibrates.\n  Give a Young's modulus "
                     "above 0 GPa.");
  find_pattern();
  assemble();
  find_rigid_modes();
  inverse = std::make_unique<ShiftedInverse>(matrix);
}

/// Rows with zeros where two nodes share a cell.
void FreeVibration::System::find_pattern()
{
  const auto neighbours = neighbours_of(body);
  std::vector<int> entries;
  for (int node = 0; node < body.n_nodes(); ++node)
  {
    entries.clear();
    for (const int other : neighbours[node])
      for (int d = 0; d < 3; ++d)
        if (number[3 * other + d] >= 0)
          entries.push_back(number[3 * other + d]);
    const std::vector<double> zeros(entries.size(), 0.);
    for (int d = 0; d < 3; ++d)
      if (const int row = number[3 * node + d]; row >= 0)
        matrix.InsertGlobalValues(row, static_cast<int>(entries.size()), zeros.data(),
                                  entries.data());
  }
  matrix.FillComplete();
}

void FreeVibration::System::assemble()
{
  for (int cell = 0; cell < static_cast<int>(body.solid().cells.size()); ++cell)
  {
    const auto K        = body.stiffness(cell);
    const auto &corners = body.solid().cells[cell];
    for (int i = 0; i < 24; ++i)
    {
      const int row = number[3 * corners[i / 3] + i % 3];
      std::array<int, 24> entries;
      std::array<double, 24> values;
      int n = 0;
      for (int j = 0; j < 24 && row >= 0; ++j)
        if (const int column = number[3 * corners[j / 3] + j % 3]; column >= 0)
        {
          entries[n]  = column;
          values[n++] = K(i, j) / (sigma * root_mass[row] * root_mass[column]);
        }
      if (n > 0)
        matrix.SumIntoMyValues(row, n, values.data(), entries.data());
    }
  }
  const double one = 1.;
  for (int row = 0; row < map.NumMyElements(); ++row)
    matrix.SumIntoMyValues(row, 1, &one, &row);
}

void FreeVibration::System::find_rigid_modes()
{
  const bool planar = body.mirrored();
  rigid             = Teuchos::rcp(new Epetra_MultiVector(map, planar ? 3 : 6));
  Dense x           = columns_of(*rigid);
  for (std::size_t i = 0; i < number.size(); ++i)
    if (const int row = number[i]; row >= 0)
    {
      const Vector3 X = body.solid().nodes[i / 3];
      const int d     = static_cast<int>(i % 3);
      int column      = 0;
      for (int axis = 0; axis < 3; ++axis)
        if (!planar || axis != 1)
          x(row, column++) = root_mass[row] * (axis == d ? 1. : 0.);
      for (int axis = 0; axis < 3; ++axis)
        if (!planar || axis == 1)
          x(row, column++) = root_mass[row] * Vector3::Unit(axis).cross(X)[d];
    }
  // Gram and Schmidt, twice, which is enough for full precision.
  for (int pass = 0; pass < 2; ++pass)
    for (int i = 0; i < x.cols(); ++i)
    {
      for (int j = 0; j < i; ++j)
        x.col(i) -= x.col(j).dot(x.col(i)) * x.col(j);
      x.col(i).normalize();
    }
}

void FreeVibration::System::deflate(Dense x) const
{
  const Dense r = columns_of(*rigid);
  for (int pass = 0; pass < 2; ++pass)
    x -= r * (r.transpose() * x).eval();
}

std::vector<double> FreeVibration::System::on_nodes(const Eigen::VectorXd &x) const
{
  std::vector<double> values(number.size(), 0.);
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0)
      values[i] = x[number[i]] / root_mass[number[i]];
  return values;
}

FreeModes FreeVibration::System::modes_from(const Eigen::MatrixXd &span) const
{
  Epetra_MultiVector x(map, static_cast<int>(span.cols())), image(x);
  columns_of(x) = span;
  deflate(columns_of(x));
  Dense basis = columns_of(x);
  basis       = Eigen::HouseholderQR<Eigen::MatrixXd>(basis).householderQ() *
          Eigen::MatrixXd::Identity(basis.rows(), basis.cols());
  matrix.Apply(x, image);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(basis.transpose() * columns_of(image));
  const Eigen::MatrixXd found = basis * ritz.eigenvectors();
  FreeModes modes;
  for (int k = 0; k < found.cols(); ++k)
  {
    modes.squared_frequency.push_back(sigma * (ritz.eigenvalues()[k] - 1.));
    Eigen::Index largest;
    found.col(k).cwiseAbs().maxCoeff(&largest); // whose sign is chosen
    modes.shape.push_back(on_nodes(std::copysign(1., found(largest, k)) * found.col(k)));
  }
  // A beam bends at 5.6 (d/L) sqrt(sigma), d/L its slenderness: this would be one of 1 to 20000.
  if (modes.squared_frequency.front() < 1e-7 * sigma)
    throw InputError("The projectile's mesh has parts that turn against each other freely.\n  Mesh "
                     "the body as one piece, whose cells share faces.");
  return modes;
}

FreeVibration::FreeVibration(const HexahedralBody &body) : system_(std::make_unique<System>(body))
{
}

FreeVibration::~FreeVibration() = default;

FreeModes FreeVibration::lowest_modes(const int n) const
{
  const auto &s  = *system_;
  const int size = degrees_of_freedom(s.body), most = most_free_modes(s.body);
  if (n < 1 || n > most)
    throw InputError("A projectile's mesh of " + std::to_string(size) +
                     " degrees of freedom has at most " + std::to_string(most) +
                     " modes that are the body's own, a third of them; " + std::to_string(n) +
                     " were asked for.\n  Lower 'Projectile/Modes' or refine the mesh.");
  // Two vectors at a time find the pairs of equal frequency that a round body has; a Krylov space
  // of twice the wanted directions and some.
  constexpr int block = 2;
  const auto start    = Teuchos::rcp(new Epetra_MultiVector(s.map, block));
  Dense first         = columns_of(*start);
  for (int i = 0; i < first.rows(); ++i)
    for (int k = 0; k < block; ++k)
      first(i, k) = noise_at(Vector3(i, 0., 0.), k);
  s.deflate(first);

  using Vectors        = Epetra_MultiVector;
  using Operator       = Epetra_Operator;
  const auto operation = Teuchos::rcp<const Operator>(s.inverse.get(), /*owns=*/false);
  const auto problem =
      Teuchos::rcp(new Anasazi::BasicEigenproblem<double, Vectors, Operator>(operation, start));
  problem->setHermitian(true);
  problem->setNEV(n);
  problem->setAuxVecs(s.rigid);
  problem->setProblem();
  Teuchos::ParameterList options;
  options.set("Which", "LM");
  options.set("Block Size", block);
  options.set("Num Blocks", std::min((2 * n + 20) / block, (size - block) / block));
  options.set("Maximum Restarts", 50);
  options.set("Convergence Tolerance", 1e-12);
  options.set("Verbosity", static_cast<int>(Anasazi::Errors));
  Anasazi::BlockKrylovSchurSolMgr<double, Vectors, Operator> solver(problem, options);
  if (solver.solve() != Anasazi::Converged)
    throw RunError("The " + std::to_string(n) +
                   " lowest modes of the projectile have not been found: the Krylov process does "
                   "not converge.\n  Ask for fewer modes, or mesh the body again with better "
                   "elements.");
  return s.modes_from(columns_of(*problem->getSolution().Evecs));
}

std::vector<double> FreeVibration::static_displacement(const std::vector<double> &force) const
{
  const auto &s = *system_;
  Epetra_MultiVector load(s.map, 1), x(s.map, 1), residual(s.map, 1);
  for (std::size_t i = 0; i < s.number.size(); ++i)
    if (const int row = s.number[i]; row >= 0)
      load[0][row] = force[i] / (s.sigma * s.root_mass[row]);
  s.deflate(columns_of(load));
  // A x = f by x <- (A + 1)^-1 (f + x): the error falls by 1/(1 + omega_1^2/sigma) each time.
  for (int iteration = 0; iteration < 200; ++iteration)
  {
    residual = load;
    residual.Update(1., x, 1.);
    const Eigen::VectorXd before = columns_of(x).col(0);
    s.inverse->Apply(residual, x);
    s.deflate(columns_of(x));
    const Eigen::VectorXd now = columns_of(x).col(0);
    if ((now - before).norm() <= 1e-12 * now.norm())
      break;
  }
  return s.on_nodes(columns_of(x).col(0));
}
} // namespace ricochet
