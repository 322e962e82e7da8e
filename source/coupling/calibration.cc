// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/calibration.h"

#include "ricochet/base/exchange.h"
#include "ricochet/coupling/slaved_points.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Tensor  = std::array<double, HexTensors::n_entries>;

// A node whose force is too large is mended by the elements so many grid spacings away.
constexpr int mending_range           = 6;
// Points whose neighbours lack neighbours are softer than those inside. What they do can be mended
// in part only, and takes many iterations: at nodes that feel them forces may be so much larger.
constexpr double rim_factor           = 5.;
// Zones are symmetric, so that conjugate gradients know nothing of modes which rounding alone
// excites: these would grow a little with each step, differently on any number of ranks.
constexpr int turns_before_forgetting = 21;

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

Tensor packed(const Matrix6 &m)
{
  Tensor t;
  for (int i = 0, k = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j)
      t[k++] = m(i, j);
  return t;
}

Matrix6 unpacked(const Tensor &t)
{
  Matrix6 m;
  for (int i = 0, k = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j)
      m(i, j) = m(j, i) = t[k++];
  return m;
}

void add(const double factor, const Tensor &x, Tensor &y)
{
  for (int k = 0; k < HexTensors::n_entries; ++k)
    y[k] += factor * x[k];
}

struct Nodal : std::vector<StrainForces>
{
  explicit Nodal(const std::size_t n = 0) :
    std::vector<StrainForces>(
        n, StrainForces{StrainLanes::Zero(), StrainLanes::Zero(), StrainLanes::Zero()})
  {
  }
};

/// What a rank has found and tells the others.
struct Finding
{
  std::uint64_t pattern, similar;
  std::int64_t cell; // the first of those with the pattern counts, on any number of ranks
  std::array<Tensor, 8> tensors;
};
} // namespace

/// The elements around the zone as unknowns: forces in units of M h^2, stiffness in those of M.
class Calibration::LeastSquares
{
public:
  LeastSquares(Calibration &owner) :
    communicator_(owner.communicator_), mesh_(owner.elements_.mesh()),
    lattice_(owner.points_.lattice()), zone_(*lattice_.zone()), options_(owner.options_)
  {
    MPI_Comm_size(communicator_, &n_ranks_);
    const double K = owner.moduli_.bulk, mu = owner.moduli_.shear;
    modulus_ = K + 4. / 3. * mu;
    edge_    = lattice_.zone()->points_per_edge() * lattice_.box().spacing;
    solid_.setZero();
    solid_.topLeftCorner<3, 3>().setConstant((K - 2. / 3. * mu) / modulus_);
    for (int i = 0; i < 6; ++i)
      solid_(i, i) += (i < 3 ? 2. : 1.) * mu / modulus_;
    find_elements();
    number_nodes();
    start(owner);
  }

  void solve(CalibrationReport &report)
  {
    report              = {};
    report.ghost_before = largest(residual_);
    // C may become negative where little is left of it. What is cut off then is sought again, from
    // there; the part of the solution space without negative eigenvalues is convex.
    while (report.n_iterations < options_.n_iterations && excess() > 1.)
    {
      choose_active();
      turn();
      report.n_iterations +=
          improve(std::min(options_.round, options_.n_iterations - report.n_iterations));
      report.smallest_eigenvalue = std::min(report.smallest_eigenvalue, clip());
    }
    report.ghost_after = largest(residual_);
    MPI_Allreduce(MPI_IN_PLACE, &report.smallest_eigenvalue, 1, MPI_DOUBLE, MPI_MIN, communicator_);
    report.n_elements = static_cast<std::int64_t>(elements_.size());
    MPI_Allreduce(MPI_IN_PLACE, &report.n_elements, 1, MPI_INT64_T, MPI_SUM, communicator_);
  }

  std::vector<ElementStiffness> stiffness() const
  {
    std::vector<ElementStiffness> result(elements_.size());
    for (std::size_t i = 0; i < elements_.size(); ++i)
    {
      result[i].element = elements_[i].number;
      for (int g = 0; g < 8; ++g)
        for (int k = 0; k < HexTensors::n_entries; ++k)
          result[i].tensors[g][k] = modulus_ * elements_[i].tensors[g][k];
    }
    return result;
  }

  std::unordered_map<std::size_t, Present> present() const
  {
    std::unordered_map<std::size_t, Present> result;
    for (const auto &element : elements_)
      result[zone_.number(element.cell)] = {element.pattern, element.tensors};
    return result;
  }

  std::vector<Finding> findings(const std::unordered_map<std::uint64_t, Tensors> &known) const
  {
    std::vector<Finding> result;
    for (const auto &element : elements_)
      if (known.count(element.pattern) == 0)
        result.push_back({element.pattern, similar(element.cell),
                          static_cast<std::int64_t>(zone_.number(element.cell)), element.tensors});
    return result;
  }

private:
  /// Less than a horizon from a free face points lack neighbours and are softer than any element:
  /// what the bonds do there cannot be mended, and trying would spoil the elements around.
  enum class NodeRole : char
  {
    inside,
    mirror,
    skin
  };
  struct Element
  {
    int number; // in the mesh
    Zone::Cell cell;
    std::uint64_t pattern;
    std::array<int, 8> corner; // in nodes_
    Tensors tensors;
    bool kept; // surroundings and tensors are those of the last time
  };

  void find_elements()
  {
    for (std::size_t e = 0; e < mesh_.elements().size(); ++e)
    {
      const auto &element = mesh_.elements()[e];
      if (element.edge > 1.5 * edge_)
        continue;
      const auto cell = cell_at(lattice_, mesh_.centre(element));
      if (zone_.is_slaved(cell))
        elements_.push_back({static_cast<int>(e),
                             cell,
                             cell_pattern(zone_, cell, lattice_.box().mirror_y),
                             {},
                             {},
                             false});
    }
  }

  std::uint64_t similar(const Zone::Cell &cell) const
  {
    return cell_pattern(zone_, cell, lattice_.box().mirror_y, /*alike=*/true);
  }

  /// Only nodes of these elements matter, those of other ranks' elements included.
  void number_nodes()
  {
    std::vector<double> touched(3 * static_cast<std::size_t>(mesh_.n_nodes()), 0.);
    for (const auto &element : elements_)
      for (const int node : mesh_.elements()[element.number].nodes)
        touched[3 * node] = 1.;
    if (n_ranks_ > 1)
    {
      auto owned = touched;
      mesh_.add_to_owners(owned.data());
      for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
        touched[3 * node] = owned[3 * node];
    }
    std::vector<int> number(mesh_.n_nodes(), -1);
    for (int node = 0; node < mesh_.n_nodes(); ++node)
      if (touched[3 * node] > 0.)
      {
        number[node] = static_cast<int>(nodes_.size());
        nodes_.push_back(node);
      }
    for (const int node : nodes_)
    {
      const auto &box      = lattice_.box();
      const double horizon = lattice_.stencil().horizon * (1. - 1e-9),
                   softer  = 2. * lattice_.stencil().reach * box.spacing * (1. + 1e-9);
      const Vector3 low    = mesh_.reference_position(node) - box.corner,
                    high   = box.spacing * Vector3(box.n[0], box.n[1], box.n[2]) - low;
      bool skin = false, rim = false;
      for (int d = 0; d < 3; ++d)
      {
        const double depth = d == 1 && box.mirror_y ? high[d] : std::min(low[d], high[d]);
        skin               = skin || depth < horizon;
        rim                = rim || depth < softer;
      }
      allowed_.push_back((rim ? rim_factor : 1.) * options_.tolerance);
      role_.push_back(skin                          ? NodeRole::skin
                      : mesh_.on_mirror_plane(node) ? NodeRole::mirror
                                                    : NodeRole::inside);
    }
    for (auto &element : elements_)
      for (int a = 0; a < 8; ++a)
        element.corner[a] = number[mesh_.elements()[element.number].nodes[a]];
  }

  /// First tensors and their residual: bonds plus what the elements have less than in full, minus
  /// the elements that the cells of the zone would be.
  void start(Calibration &owner)
  {
    residual_         = Nodal(nodes_.size());
    const double unit = 1. / (modulus_ * edge_ * edge_);
    const Tensor full = packed(solid_);
    for (auto &element : elements_)
    {
      const auto &bonds = owner.forces_.of(element.cell, element.pattern);
      for (int a = 0; a < 8; ++a)
        for (int c = 0; c < 3; ++c)
          residual_[element.corner[a]][c] += unit * bonds.corner[a][c];
      if (const auto present = owner.present_.find(zone_.number(element.cell));
          present != owner.present_.end() && present->second.pattern == element.pattern)
      {
        element.tensors = present->second.tensors;
        element.kept    = true;
      }
      else if (const auto same = owner.found_.find(element.pattern); same != owner.found_.end())
        element.tensors = same->second;
      else if (const auto near = owner.similar_.find(similar(element.cell));
               near != owner.similar_.end())
        element.tensors = near->second;
      else
        element.tensors.fill(packed(std::clamp(1. - bonds.stress_share, 0., 1.) * solid_));
      Tensors less = element.tensors;
      for (auto &tensor : less)
        add(-1., full, tensor);
      apply(element, less, residual_);
    }
    subtract_free_cells();
    complete(residual_);
  }

  void subtract_free_cells()
  {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
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
            // f = -sigma s h^2/4
            const double sign = (corner >> d) & 1 ? 0.25 : -0.25;
            for (int k = 0; k < n_unit_strains; ++k)
              residual_[i][c][k] += sign * solid_(voigt_number[c][d], k);
          }
      }
    }
  }

  /// Adds elements near nodes whose force is too large; to make it smaller than need be is left to
  /// nodes of elements that are new.
  void choose_active()
  {
    std::vector<char> marked(nodes_.size()), is_new(nodes_.size());
    for (const auto &element : elements_)
      if (!element.kept)
        for (const int node : element.corner)
          is_new[node] = 1;
    share(is_new);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (const auto &lanes : residual_[i])
        marked[i] = marked[i] || lanes.abs().maxCoeff() > (is_new[i] ? 0.5 : 1.) * allowed_[i];
    std::vector<char> chosen(elements_.size());
    const int n_steps = std::max(1, mending_range / zone_.points_per_edge());
    for (int step = 0; step < n_steps; ++step)
    {
      for (std::size_t i = 0; i < elements_.size(); ++i)
        chosen[i] = std::any_of(elements_[i].corner.begin(), elements_[i].corner.end(),
                                [&](const int node) { return marked[node] != 0; });
      for (std::size_t i = 0; i < elements_.size(); ++i)
        if (chosen[i])
          for (const int node : elements_[i].corner)
            marked[node] = 1;
      share(marked);
    }
    for (const int i : active_)
      chosen[i] = 1;
    active_.clear();
    for (std::size_t i = 0; i < elements_.size(); ++i)
      if (chosen[i])
        active_.push_back(static_cast<int>(i));
  }

  /// What one rank has marked is marked on all that know the node.
  void share(std::vector<char> &marked) const
  {
    if (n_ranks_ == 1)
      return;
    std::vector<double> values(3 * static_cast<std::size_t>(mesh_.n_nodes()), 0.);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      values[3 * nodes_[i]] = marked[i];
    mesh_.add_to_owners(values.data());
    mesh_.update_ghosts(values.data());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      marked[i] = values[3 * nodes_[i]] > 0.;
  }

  /// The next direction of descent: with what the last one is worth, by Polak and Ribiere, who
  /// forgive that tensors were clipped in between or others have become active.
  void turn()
  {
    for (auto *tensors : {&slope_, &last_slope_, &direction_})
      tensors->resize(elements_.size(), Tensors{});
    slope_.swap(last_slope_);
    downhill(slope_);
    const double squared = product(slope_, slope_);
    const bool forget    = n_turns_++ % turns_before_forgetting == 0;
    const double share =
        forget ? 0. : std::max(0., (squared - product(slope_, last_slope_)) / squared_);
    squared_ = squared;
    for (const int i : active_)
      for (int g = 0; g < 8; ++g)
        for (int k = 0; k < HexTensors::n_entries; ++k)
          direction_[i][g][k] = slope_[i][g][k] + share * direction_[i][g][k];
  }

  /// At most so many steps of conjugate gradients towards the smallest residual with the smallest
  /// change of the active tensors; returns how many.
  int improve(const int n_iterations)
  {
    for (int iteration = 1; squared_ > 0.; ++iteration)
    {
      Nodal image(nodes_.size());
      for (const int i : active_)
        apply(elements_[i], direction_[i], image);
      complete(image);
      const double step = product(slope_, direction_) / product(image);
      for (const int i : active_)
        for (int g = 0; g < 8; ++g)
          add(step, direction_[i][g], elements_[i].tensors[g]);
      for (std::size_t i = 0; i < residual_.size(); ++i)
        for (int c = 0; c < 3; ++c)
          residual_[i][c] += step * image[i][c];
      if (iteration == n_iterations || excess() < 1.)
        return iteration;
      turn();
    }
    return n_iterations;
  }

  /// Raises negative eigenvalues to zero if asked, and keeps the residual up to date; returns the
  /// smallest one on this rank, or zero.
  double clip()
  {
    Nodal image(nodes_.size());
    double smallest = 0.;
    for (const int i : active_)
    {
      Tensors change{};
      bool changed = false;
      for (int g = 0; g < 8; ++g)
      {
        const Matrix6 m = unpacked(elements_[i].tensors[g]);
        // Most are positive, and this is the quick way to know.
        if (Eigen::LLT<Matrix6>(m + 1e-9 * Matrix6::Identity()).info() == Eigen::Success)
          continue;
        const Eigen::SelfAdjointEigenSolver<Matrix6> solver(m);
        smallest = std::min(smallest, solver.eigenvalues()[0]);
        if (!options_.clip || solver.eigenvalues()[0] >= 0.)
          continue;
        const Matrix6 kept = solver.eigenvectors() *
                             solver.eigenvalues().cwiseMax(0.).asDiagonal() *
                             solver.eigenvectors().transpose();
        change[g]               = packed(kept - m);
        elements_[i].tensors[g] = packed(kept);
        changed                 = true;
      }
      if (changed)
        apply(elements_[i], change, image);
    }
    complete(image);
    for (std::size_t i = 0; i < residual_.size(); ++i)
      for (int c = 0; c < 3; ++c)
        residual_[i][c] += image[i][c];
    return smallest;
  }

  /// Adds the nodal forces of an element with these tensors.
  static void apply(const Element &element, const Tensors &tensors, Nodal &forces)
  {
    StrainForces f[8];
    for (auto &corner : f)
      corner = {StrainLanes::Zero(), StrainLanes::Zero(), StrainLanes::Zero()};
    for (int g = 0; g < 8; ++g)
    {
      StrainLanes row[6];
      for (auto &lanes : row)
        lanes.setZero();
      for (int i = 0, k = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j, ++k)
          row[i][j] = row[j][i] = tensors[g][k];
      for (int a = 0; a < 8; ++a)
      {
        const double *n = gradients.n[g][a];
        for (int c = 0; c < 3; ++c)
          f[a][c] += row[voigt_number[c][0]] * n[0] + row[voigt_number[c][1]] * n[1] +
                     row[voigt_number[c][2]] * n[2];
      }
    }
    for (int a = 0; a < 8; ++a)
      for (int c = 0; c < 3; ++c)
        forces[element.corner[a]][c] -= 0.125 * f[a][c];
  }

  /// Minus the transpose of apply(), of the residual.
  void downhill(std::vector<Tensors> &slope) const
  {
    for (const int i : active_)
      for (int g = 0; g < 8; ++g)
      {
        StrainLanes s[6];
        for (auto &lanes : s)
          lanes.setZero();
        for (int a = 0; a < 8; ++a)
        {
          const auto &f   = residual_[elements_[i].corner[a]];
          const double *n = gradients.n[g][a];
          for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d)
              s[voigt_number[c][d]] += n[d] * f[c];
        }
        for (int m = 0, k = 0; m < 6; ++m)
          for (int n = m; n < 6; ++n, ++k)
            slope[i][g][k] = 0.125 * (m == n ? s[m][n] : s[m][n] + s[n][m]);
      }
  }

  /// Contributions of all ranks, the same at owners and ghosts. On the symmetry plane only what the
  /// other half does not cancel; nothing in the skin of the plate.
  void complete(Nodal &forces) const
  {
    if (n_ranks_ > 1)
    {
      std::vector<double> values(3 * static_cast<std::size_t>(mesh_.n_nodes()));
      for (int k = 0; k < n_unit_strains; ++k)
      {
        std::fill(values.begin(), values.end(), 0.);
        for (std::size_t i = 0; i < nodes_.size(); ++i)
          for (int c = 0; c < 3; ++c)
            values[3 * nodes_[i] + c] = forces[i][c][k];
        mesh_.add_to_owners(values.data());
        mesh_.update_ghosts(values.data());
        for (std::size_t i = 0; i < nodes_.size(); ++i)
          for (int c = 0; c < 3; ++c)
            forces[i][c][k] = values[3 * nodes_[i] + c];
      }
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (role_[i] == NodeRole::skin)
        forces[i] = {StrainLanes::Zero(), StrainLanes::Zero(), StrainLanes::Zero()};
      else if (role_[i] == NodeRole::mirror)
        for (int k = 0; k < n_unit_strains; ++k)
        {
          const bool symmetric = k != voigt_number[1][2] && k != voigt_number[0][1];
          for (int c = 0; c < 3; ++c)
            if (symmetric == (c == 1))
              forces[i][c][k] = 0.;
        }
  }

  double product(const Nodal &x) const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (nodes_[i] < mesh_.n_owned_nodes())
        for (const auto &lanes : x[i])
          sum += lanes.square().sum();
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return sum;
  }
  double product(const std::vector<Tensors> &x, const std::vector<Tensors> &y) const
  {
    double sum = 0.;
    for (const int i : active_)
      for (int g = 0; g < 8; ++g)
        for (int k = 0; k < HexTensors::n_entries; ++k)
          sum += x[i][g][k] * y[i][g][k];
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

  /// The largest force in units of what is allowed there.
  double excess() const
  {
    double most = 0.;
    for (std::size_t i = 0; i < residual_.size(); ++i)
      for (const auto &lanes : residual_[i])
        most = std::max(most, lanes.abs().maxCoeff() / allowed_[i]);
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    return most;
  }

  MPI_Comm communicator_;
  int n_ranks_;
  const HexMesh &mesh_;
  const Lattice &lattice_;
  const Zone &zone_;
  CalibrationOptions options_;
  double modulus_, edge_; // M [Pa], h [m]
  Matrix6 solid_;         // of the plain elements
  std::vector<Element> elements_;
  std::vector<int> nodes_;      // local numbers in the mesh
  std::vector<NodeRole> role_;  // of nodes_
  std::vector<double> allowed_; // force at nodes_ [-]
  std::vector<int> active_;     // numbers of elements_ that change
  Nodal residual_;
  // Of the conjugate gradients, per entry of elements_; zero but for active ones.
  std::vector<Tensors> slope_, last_slope_, direction_;
  double squared_ = 0.;
  int n_turns_    = 0;
};

Calibration::Calibration(const MPI_Comm communicator, const PeridynamicBody &points,
                         const FiniteElementBody &elements, const ElasticModuli &moduli,
                         const CalibrationOptions &options) :
  communicator_(communicator),
  points_(points), elements_(elements), moduli_(moduli), options_(options), forces_(points, moduli)
{
}

Calibration::~Calibration() = default;

std::vector<ElementStiffness> Calibration::find()
{
  LeastSquares problem(*this);
  problem.solve(report_);
  remember(problem);
  return problem.stiffness();
}

void Calibration::remember(const LeastSquares &problem)
{
  present_       = problem.present();
  const auto own = problem.findings(found_);
  int n_ranks;
  MPI_Comm_size(communicator_, &n_ranks);
  auto all = joined(exchange_lists(communicator_, std::vector<std::vector<Finding>>(n_ranks, own)));
  std::sort(all.begin(), all.end(),
            [](const Finding &a, const Finding &b) { return a.cell < b.cell; });
  for (const auto &finding : all)
  {
    found_.emplace(finding.pattern, finding.tensors);
    similar_.emplace(finding.similar, finding.tensors);
  }
}
} // namespace ricochet
