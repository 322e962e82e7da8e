// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/calibration.h"

#include "ricochet/coupling/slaved_points.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace ricochet
{
namespace
{
// All six unit strains (11, 22, 33, 23, 13, 12; shear strains in the engineering sense) are treated
// at once; two lanes stay empty. Forces are in units of M h^2, stiffness in those of M = K + 4
// mu/3.
constexpr int n_strains = 6;
using Lanes             = Eigen::Array<double, 8, 1>;
using Triple            = std::array<Lanes, 3>; // per component of a force
using Tensor            = std::array<double, HexTensors::n_entries>;

constexpr int voigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

/// dN_a/dX_d times the edge, at the Gauss points.
struct Gradients
{
  double n[8][8][3]; // [Gauss point][corner][direction]

  Gradients()
  {
    const double at = 1. / std::sqrt(3.);
    for (int g = 0; g < 8; ++g)
      for (int a = 0; a < 8; ++a)
        for (int d = 0; d < 3; ++d)
        {
          double value = (a >> d) & 1 ? 1. : -1.;
          for (int o = 0; o < 3; ++o)
            if (o != d)
              value *= 0.5 * (1. + ((a >> o) & 1 ? 1. : -1.) * ((g >> o) & 1 ? at : -at));
          n[g][a][d] = value;
        }
  }
};
const Gradients gradients;

/// The shape functions at the centres of the sub-cubes.
double shape(const int corner, const int sub_cube)
{
  double value = 1.;
  for (int d = 0; d < 3; ++d)
    value *= ((corner ^ sub_cube) >> d) & 1 ? 0.25 : 0.75;
  return value;
}

/// Forces of the bonds of single points in a uniformly strained plate.
class BondForces
{
public:
  /// With these parts of the moduli.
  BondForces(const PeridynamicForce &points, const double bulk_modulus,
             const double shear_modulus) :
    lattice_(points.lattice()),
    n_(lattice_.box().n), mirrored_(lattice_.box().mirror_y), reach_(lattice_.stencil().reach),
    has_dilatation_(points.material().law->has_dilatation)
  {
    const auto &zone = *lattice_.zone();
    weight_.resize(static_cast<std::size_t>(n_[0]) * n_[1] * n_[2]);
    std::size_t i = 0;
    for (int x = 0; x < n_[0]; ++x)
      for (int y = 0; y < n_[1]; ++y)
        for (int z = 0; z < n_[2]; ++z)
          weight_[i++] = static_cast<float>(zone.weight(x, y, z));
    const auto &law     = *points.material().law;
    const auto family   = family_constants(lattice_.stencil(), bulk_modulus, shear_modulus);
    const auto &offsets = lattice_.stencil().offsets;
    for (std::size_t k = 0; k < offsets.size(); ++k)
      for (const int sign : {1, -1})
      {
        const auto &o = offsets[k];
        const auto c  = law.bond(family, o.length, o.omega);
        const Vector3 unit =
            Vector3(sign * o.x, sign * o.y, sign * o.z) * lattice_.stencil().spacing / o.length;
        Bond bond{{sign * o.x, sign * o.y, sign * o.z},
                  unit,
                  Lanes::Zero(),
                  c.dilatation,
                  c.volumetric,
                  c.extension};
        for (int d = 0; d < 3; ++d)
          bond.extension[d] = unit[d] * unit[d] * o.length;
        bond.extension[3] = unit[1] * unit[2] * o.length;
        bond.extension[4] = unit[0] * unit[2] * o.length;
        bond.extension[5] = unit[0] * unit[1] * o.length;
        bonds_.push_back(bond);
      }
  }

  /// Force on a point [N].
  Triple operator()(const int x, const int y, const int z)
  {
    Triple force{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
    const double own  = weight(x, y, z);
    const Lanes theta = own * dilatation(x, y, z);
    for (const auto &bond : bonds_)
    {
      const int qx = x + bond.offset[0], qz = z + bond.offset[2];
      int qy = y + bond.offset[1];
      if (mirrored_ && qy < 0)
        qy = -1 - qy; // of an image only weight and dilatation are asked, see below
      if (qx < 0 || qx >= n_[0] || qy < 0 || qy >= n_[1] || qz < 0 || qz >= n_[2])
        continue;
      const double other = weight(qx, qy, qz);
      if (own + other <= 0.)
        continue;
      Lanes tension = bond.stiffness * 0.5 * (own + other) * bond.extension;
      // The dilatation of an image under 23 and 12 is minus that of its original; but near the
      // plane these strains dilate nothing.
      if (has_dilatation_)
        tension += bond.volumetric * (theta + other * dilatation(qx, qy, qz));
      for (int d = 0; d < 3; ++d)
        force[d] += tension * bond.unit[d];
    }
    return force;
  }

  double weight(const int x, const int y, const int z) const
  {
    return weight_[(static_cast<std::size_t>(x) * n_[1] + y) * n_[2] + z];
  }

  struct Bond
  {
    std::array<int, 3> offset;
    Vector3 unit;
    Lanes extension; // under the unit strains [m]
    double dilatation, volumetric, stiffness;
  };
  const std::vector<Bond> &bonds() const { return bonds_; }

private:
  /// Of a point with all its bonds inside the plate; depends only on how near the faces are.
  const Lanes &dilatation(const int x, const int y, const int z)
  {
    const int at[3] = {x, y, z};
    int low[3], high[3], key = 0;
    for (int d = 0; d < 3; ++d)
    {
      low[d]  = mirrored_ && d == 1 ? reach_ : std::min(reach_, at[d]);
      high[d] = std::min(reach_, n_[d] - 1 - at[d]);
      key     = (key * (reach_ + 1) + low[d]) * (reach_ + 1) + high[d];
    }
    const auto [entry, is_new] = dilatations_.emplace(key, Lanes::Zero());
    if (is_new)
      for (const auto &bond : bonds_)
      {
        bool inside = true;
        for (int d = 0; d < 3; ++d)
          inside = inside && bond.offset[d] >= -low[d] && bond.offset[d] <= high[d];
        if (inside)
          entry->second += bond.dilatation * bond.extension;
      }
    return entry->second;
  }

  const Lattice &lattice_;
  std::array<int, 3> n_;
  bool mirrored_;
  int reach_;
  bool has_dilatation_;
  std::vector<float> weight_;
  std::vector<Bond> bonds_;
  std::unordered_map<int, Lanes> dilatations_;
};

class LeastSquares
{
public:
  /// With these parts of the moduli: all is linear in them.
  LeastSquares(const MPI_Comm communicator, const PeridynamicForce &points,
               const FiniteElementForce &elements, const double bulk_modulus,
               const double shear_modulus) :
    communicator_(communicator),
    points_(points), mesh_(elements.mesh()), lattice_(points.lattice()), zone_(*lattice_.zone()),
    bulk_modulus_(bulk_modulus), shear_modulus_(shear_modulus)
  {
    MPI_Comm_size(communicator, &n_ranks_);
    const double K = bulk_modulus, mu = shear_modulus;
    modulus_ = K + 4. / 3. * mu;
    edge_    = Zone::points_per_edge * lattice_.box().spacing;
    solid_.setZero();
    solid_.topLeftCorner<3, 3>().setConstant((K - 2. / 3. * mu) / modulus_);
    for (int i = 0; i < 6; ++i)
      solid_(i, i) += (i < 3 ? 2. : 1.) * mu / modulus_;

    for (std::size_t e = 0; e < mesh_.elements().size(); ++e)
    {
      const auto &element = mesh_.elements()[e];
      if (std::abs(element.edge - edge_) > 0.1 * edge_)
        continue;
      const auto cell = cell_at(lattice_.box(), mesh_.centre(element));
      if (zone_.is_slaved(cell))
      {
        elements_.push_back(static_cast<int>(e));
        cells_.push_back(cell);
      }
    }
    number_nodes();
  }

  std::size_t n_elements() const { return elements_.size(); }

  std::vector<ElementStiffness> solve(const CalibrationOptions &options, CalibrationReport &report)
  {
    BondForces bonds(points_, bulk_modulus_, shear_modulus_);
    find_start(
        BondForces(points_, points_.material().bulk_modulus, points_.material().shear_modulus));
    residual_ = Nodal(n_nodes_);
    add_bond_forces(bonds);
    add_free_cells();
    std::vector<Tensor> change(8 * elements_.size());
    for (std::size_t i = 0; i < elements_.size(); ++i)
      for (int g = 0; g < 8; ++g)
        change[8 * i + g] = packed((start_[i] - 1.) * solid_);
    apply(change, residual_);
    complete(residual_);
    report.ghost_before = largest(residual_);

    // C may become negative where little is left of it. What is cut off then is sought again, from
    // there; the part of the solution space without negative eigenvalues is convex.
    std::vector<Tensor> stiffness(change.size());
    for (std::size_t i = 0; i < stiffness.size(); ++i)
      stiffness[i] = packed(start_[i / 8] * solid_);
    report.n_iterations        = 0;
    report.smallest_eigenvalue = std::numeric_limits<double>::max();
    while (report.n_iterations < options.n_iterations && largest(residual_) > options.tolerance)
    {
      report.n_iterations +=
          improve(std::min(options.round, options.n_iterations - report.n_iterations),
                  options.tolerance, stiffness);
      const double smallest      = clip(stiffness, options.clip);
      report.smallest_eigenvalue = std::min(report.smallest_eigenvalue, smallest);
    }
    report.ghost_after = largest(residual_);
    MPI_Allreduce(MPI_IN_PLACE, &report.smallest_eigenvalue, 1, MPI_DOUBLE, MPI_MIN, communicator_);
    report.n_elements = static_cast<std::int64_t>(elements_.size());
    MPI_Allreduce(MPI_IN_PLACE, &report.n_elements, 1, MPI_INT64_T, MPI_SUM, communicator_);

    std::vector<ElementStiffness> result(elements_.size());
    for (std::size_t i = 0; i < elements_.size(); ++i)
    {
      result[i].element = elements_[i];
      for (int g = 0; g < 8; ++g)
        for (int k = 0; k < HexTensors::n_entries; ++k)
          result[i].tensors[g][k] = modulus_ * stiffness[8 * i + g][k];
    }
    return result;
  }

private:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  struct Nodal : std::vector<Triple>
  {
    explicit Nodal(const std::size_t n = 0) :
      std::vector<Triple>(n, Triple{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()})
    {
    }
  };

  static Tensor packed(const Matrix6 &m)
  {
    Tensor t;
    int k = 0;
    for (int i = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j)
        t[k++] = m(i, j);
    return t;
  }
  static Matrix6 unpacked(const Tensor &t)
  {
    Matrix6 m;
    int k = 0;
    for (int i = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j)
        m(i, j) = m(j, i) = t[k++];
    return m;
  }

  /// At most so many steps of conjugate gradients towards the smallest residual with the smallest
  /// change of the tensors; returns how many.
  int improve(const int n_iterations, const double tolerance, std::vector<Tensor> &stiffness)
  {
    std::vector<Tensor> slope(stiffness.size()), direction;
    const auto downhill = [&]
    {
      transpose(residual_, slope);
      for (auto &tensor : slope)
        for (double &value : tensor)
          value = -value;
    };
    downhill();
    direction      = slope;
    double squared = product(slope, slope);
    for (int iteration = 1; squared > 0.; ++iteration)
    {
      Nodal image(n_nodes_);
      apply(direction, image);
      complete(image);
      const double step = squared / product(image, image);
      add(step, direction, stiffness);
      for (std::size_t i = 0; i < residual_.size(); ++i)
        for (int c = 0; c < 3; ++c)
          residual_[i][c] += step * image[i][c];
      if (iteration == n_iterations || largest(residual_) < tolerance)
        return iteration;
      downhill();
      const double next = product(slope, slope), beta = next / squared;
      squared = next;
      for (std::size_t i = 0; i < slope.size(); ++i)
        for (int k = 0; k < HexTensors::n_entries; ++k)
          direction[i][k] = slope[i][k] + beta * direction[i][k];
    }
    return n_iterations;
  }

  static void add(const double factor, const std::vector<Tensor> &x, std::vector<Tensor> &y)
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      for (int k = 0; k < HexTensors::n_entries; ++k)
        y[i][k] += factor * x[i][k];
  }

  /// Raises negative eigenvalues to zero if asked, and keeps the residual up to date; returns the
  /// smallest one on this rank.
  double clip(std::vector<Tensor> &stiffness, const bool asked)
  {
    std::vector<Tensor> change(stiffness.size(), Tensor{});
    double smallest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < stiffness.size(); ++i)
    {
      const Matrix6 m = unpacked(stiffness[i]);
      const Eigen::SelfAdjointEigenSolver<Matrix6> solver(m);
      smallest = std::min(smallest, solver.eigenvalues()[0]);
      if (!asked || solver.eigenvalues()[0] >= 0.)
        continue;
      const Matrix6 kept = solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.).asDiagonal() *
                           solver.eigenvectors().transpose();
      change[i]    = packed(kept - m);
      stiffness[i] = packed(kept);
    }
    Nodal image(n_nodes_);
    apply(change, image);
    complete(image);
    for (std::size_t i = 0; i < residual_.size(); ++i)
      for (int c = 0; c < 3; ++c)
        residual_[i][c] += image[i][c];
    return smallest;
  }

  /// Only nodes of these elements matter, those of other ranks' elements included.
  void number_nodes()
  {
    std::vector<double> touched(3 * static_cast<std::size_t>(mesh_.n_nodes()), 0.);
    for (const int e : elements_)
      for (const int node : mesh_.elements()[e].nodes)
        touched[3 * node] = 1.;
    if (n_ranks_ > 1)
    {
      auto owned = touched;
      mesh_.add_to_owners(owned.data());
      for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
        touched[3 * node] = owned[3 * node];
    }
    number_.assign(mesh_.n_nodes(), -1);
    for (int node = 0; node < mesh_.n_nodes(); ++node)
      if (touched[3 * node] > 0.)
      {
        number_[node] = static_cast<int>(nodes_.size());
        nodes_.push_back(node);
      }
    n_nodes_ = nodes_.size();
    for (const int e : elements_)
    {
      std::array<int, 8> corners;
      for (int a = 0; a < 8; ++a)
        corners[a] = number_[mesh_.elements()[e].nodes[a]];
      corners_.push_back(corners);
    }
  }

  /// Share of the bond stress that an element lacks: that of its points.
  void find_start(const BondForces &bonds)
  {
    const auto &box = lattice_.box();
    double all      = 0.;
    for (const auto &bond : bonds.bonds())
      all += bond.stiffness * bond.extension[0] * bond.unit[0] * bond.unit[0];
    for (const auto &cell : cells_)
    {
      double present    = 0.;
      const int base[3] = {2 * cell[0], 2 * cell[1], 2 * cell[2]};
      for (int sub = 0; sub < 8; ++sub)
      {
        const int p[3]   = {base[0] + (sub & 1), base[1] + ((sub >> 1) & 1), base[2] + (sub >> 2)};
        const double own = bonds.weight(p[0], p[1], p[2]);
        for (const auto &bond : bonds.bonds())
        {
          int q[3];
          bool inside = true;
          for (int d = 0; d < 3; ++d)
          {
            q[d] = p[d] + bond.offset[d];
            if (box.mirror_y && d == 1 && q[d] < 0)
              q[d] = -1 - q[d];
            inside = inside && q[d] >= 0 && q[d] < box.n[d];
          }
          const double other = inside ? bonds.weight(q[0], q[1], q[2]) : own;
          present += 0.5 * (own + other) * bond.stiffness * bond.extension[0] * bond.unit[0] *
                     bond.unit[0];
        }
      }
      start_.push_back(std::clamp(1. - present / (8. * all), 0., 1.));
    }
  }

  void add_bond_forces(BondForces &bonds)
  {
    const double unit = 1. / (modulus_ * edge_ * edge_);
    for (std::size_t i = 0; i < elements_.size(); ++i)
      for (int sub = 0; sub < 8; ++sub)
      {
        const auto &cell   = cells_[i];
        const Triple force = bonds(2 * cell[0] + (sub & 1), 2 * cell[1] + ((sub >> 1) & 1),
                                   2 * cell[2] + (sub >> 2));
        for (int a = 0; a < 8; ++a)
          for (int c = 0; c < 3; ++c)
            residual_[corners_[i][a]][c] += unit * shape(a, sub) * force[c];
      }
  }

  /// The elements that the cells of the zone would be, with the opposite sign: at owned nodes.
  void add_free_cells()
  {
    for (std::size_t i = 0; i < n_nodes_; ++i)
    {
      if (nodes_[i] >= mesh_.n_owned_nodes())
        continue;
      const Vector3 at = (mesh_.reference_position(nodes_[i]) - lattice_.box().corner) / edge_;
      for (int corner = 0; corner < 8; ++corner)
      {
        // The node is this corner of the cell.
        Zone::Cell cell;
        for (int d = 0; d < 3; ++d)
          cell[d] = static_cast<int>(std::lround(at[d])) - ((corner >> d) & 1);
        if (!zone_.contains(cell) || !zone_.is_free(cell))
          continue;
        for (int c = 0; c < 3; ++c)
          for (int d = 0; d < 3; ++d)
          {
            // f = -sigma s h^2/4, subtracted
            const double sign = (corner >> d) & 1 ? 0.25 : -0.25;
            for (int k = 0; k < n_strains; ++k)
              residual_[i][c][k] += sign * solid_(voigt[c][d], k);
          }
      }
    }
  }

  /// Adds the nodal forces of elements with these tensors, 8 per element.
  void apply(const std::vector<Tensor> &tensors, Nodal &forces) const
  {
    for (std::size_t i = 0; i < elements_.size(); ++i)
    {
      Triple f[8];
      for (auto &corner : f)
        corner = {Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
      for (int g = 0; g < 8; ++g)
      {
        Lanes row[6];
        rows_of(tensors[8 * i + g], row);
        for (int a = 0; a < 8; ++a)
        {
          const double *n = gradients.n[g][a];
          for (int c = 0; c < 3; ++c)
            f[a][c] += row[voigt[c][0]] * n[0] + row[voigt[c][1]] * n[1] + row[voigt[c][2]] * n[2];
        }
      }
      for (int a = 0; a < 8; ++a)
        for (int c = 0; c < 3; ++c)
          forces[corners_[i][a]][c] -= 0.125 * f[a][c];
    }
  }

  static void rows_of(const Tensor &t, Lanes (&row)[6])
  {
    int k = 0;
    for (auto &lanes : row)
      lanes.setZero();
    for (int i = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j, ++k)
        row[i][j] = row[j][i] = t[k];
  }

  void transpose(const Nodal &forces, std::vector<Tensor> &tensors) const
  {
    for (std::size_t i = 0; i < elements_.size(); ++i)
      for (int g = 0; g < 8; ++g)
      {
        Lanes s[6];
        for (auto &lanes : s)
          lanes.setZero();
        for (int a = 0; a < 8; ++a)
        {
          const auto &f   = forces[corners_[i][a]];
          const double *n = gradients.n[g][a];
          for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d)
              s[voigt[c][d]] += n[d] * f[c];
        }
        Tensor &t = tensors[8 * i + g];
        int k     = 0;
        for (int m = 0; m < 6; ++m)
          for (int n = m; n < 6; ++n, ++k)
            t[k] = -0.125 * (m == n ? s[m][n] : s[m][n] + s[n][m]);
      }
  }

  /// Contributions of all ranks, the same at owners and ghosts; on the symmetry plane only what the
  /// other half does not cancel.
  void complete(Nodal &forces) const
  {
    if (n_ranks_ > 1)
    {
      std::vector<double> values(3 * static_cast<std::size_t>(mesh_.n_nodes()));
      for (int k = 0; k < n_strains; ++k)
      {
        std::fill(values.begin(), values.end(), 0.);
        for (std::size_t i = 0; i < n_nodes_; ++i)
          for (int c = 0; c < 3; ++c)
            values[3 * nodes_[i] + c] = forces[i][c][k];
        mesh_.add_to_owners(values.data());
        mesh_.update_ghosts(values.data());
        for (std::size_t i = 0; i < n_nodes_; ++i)
          for (int c = 0; c < 3; ++c)
            forces[i][c][k] = values[3 * nodes_[i] + c];
      }
    }
    for (std::size_t i = 0; i < n_nodes_; ++i)
      if (mesh_.on_mirror_plane(nodes_[i]))
        for (int k = 0; k < n_strains; ++k)
        {
          const bool symmetric = k != voigt[1][2] && k != voigt[0][1];
          for (int c = 0; c < 3; ++c)
            if (symmetric == (c == 1))
              forces[i][c][k] = 0.;
        }
  }

  double product(const Nodal &x, const Nodal &y) const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < n_nodes_; ++i)
      if (nodes_[i] < mesh_.n_owned_nodes())
        for (int c = 0; c < 3; ++c)
          sum += (x[i][c] * y[i][c]).sum();
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return sum;
  }
  double product(const std::vector<Tensor> &x, const std::vector<Tensor> &y) const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (int k = 0; k < HexTensors::n_entries; ++k)
        sum += x[i][k] * y[i][k];
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return sum;
  }
  double largest(const Nodal &forces) const
  {
    double most = 0.;
    for (const auto &force : forces)
      for (const auto &lanes : force)
        most = std::max(most, lanes.abs().maxCoeff());
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    return most;
  }

  MPI_Comm communicator_;
  int n_ranks_;
  const PeridynamicForce &points_;
  const HexMesh &mesh_;
  const Lattice &lattice_;
  const Zone &zone_;
  double bulk_modulus_, shear_modulus_; // [Pa]
  double modulus_, edge_;               // [Pa], [m]
  Matrix6 solid_;                       // of the plain elements [-]
  std::vector<int> elements_;
  std::vector<Zone::Cell> cells_;
  std::vector<std::array<int, 8>> corners_; // in the numbers below
  std::vector<int> nodes_, number_;         // local numbers of the mesh, and back
  std::size_t n_nodes_ = 0;
  std::vector<double> start_; // w of each element
  Nodal residual_{0};
};
} // namespace

std::vector<ElementStiffness> calibrate(const MPI_Comm communicator, const PeridynamicForce &points,
                                        const FiniteElementForce &elements,
                                        const CalibrationOptions &options,
                                        CalibrationReport &report)
{
  const double K = elements.material().bulk_modulus, mu = elements.material().shear_modulus;
  const auto solve =
      [&](const double bulk_modulus, const double shear_modulus, CalibrationReport &part)
  {
    LeastSquares problem(communicator, points, elements, bulk_modulus, shear_modulus);
    return problem.solve(options, part);
  };
  if (elements.material().relaxation.empty())
    return solve(K, mu, report);

  // Two parts, each without negative eigenvalues, so that any relaxed sum has none either.
  CalibrationReport of_shear;
  auto all         = solve(K, 0., report);
  const auto shear = solve(0., mu, of_shear);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (int g = 0; g < 8; ++g)
      for (int k = 0; k < HexTensors::n_entries; ++k)
      {
        all[i].shear[g][k] = shear[i].tensors[g][k];
        all[i].tensors[g][k] += shear[i].tensors[g][k];
      }
  report = {std::max(report.ghost_before, of_shear.ghost_before),
            std::max(report.ghost_after, of_shear.ghost_after),
            std::min(report.smallest_eigenvalue, of_shear.smallest_eigenvalue),
            report.n_iterations + of_shear.n_iterations, report.n_elements};
  return all;
}
} // namespace ricochet
