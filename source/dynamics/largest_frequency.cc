// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/dynamics/largest_frequency.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ricochet
{
namespace
{
// Largest displacement, in distances between points: linear to that accuracy, and far above the
// rounding that is left of |xi + eta| - |xi|.
constexpr double amplitude = 5e-6;

/// A body that is displaced and asked for its accelerations; at rest again in the end.
class Shaker
{
public:
  Shaker(const MPI_Comm communicator, Body &body) :
    communicator_(communicator), vibration_(body.vibration())
  {
    u.resize(vibration_->size());
    a.resize(u.size());
    vibration_->excite(u);
    normalise();
  }
  Shaker(const Shaker &)            = delete;
  Shaker &operator=(const Shaker &) = delete;
  ~Shaker() { vibration_->rest(); }

  std::vector<double> u, a; // displacements of any size and accelerations, of this rank

  double product(const std::vector<double> &x, const std::vector<double> &y) const
  {
    return vibration_->product(x, y);
  }

  /// Divides u by its norm and returns that.
  double normalise()
  {
    const double norm = std::sqrt(product(u, u));
    for (double &x : u)
      x /= norm;
    return norm;
  }

  /// a = M^-1 K u.
  void respond()
  {
    double largest = 0.;
    for (const double x : u)
      largest = std::max(largest, std::abs(x));
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    const double factor = amplitude * vibration_->spacing() / largest;
    for (std::size_t i = 0; i < u.size(); ++i)
      a[i] = factor * u[i];
    vibration_->displace(a);
    const auto start = std::chrono::steady_clock::now();
    vibration_->evaluate();
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ++n_evaluations_;
    vibration_->acceleration(a);
    for (double &x : a)
      x /= factor;
  }

  /// With what it took to find that eigenvalue. Collective.
  FrequencyEstimate estimate(const double eigenvalue) const
  {
    double seconds = seconds_ / n_evaluations_;
    MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    return {eigenvalue, seconds, n_evaluations_};
  }
  /// Unknowns of all ranks.
  double size() const
  {
    double n = static_cast<double>(u.size());
    MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return n;
  }

private:
  MPI_Comm communicator_;
  std::unique_ptr<Vibration> vibration_;
  double seconds_    = 0.;
  int n_evaluations_ = 0;
};

/// What Lanczos' process finds: a tridiagonal matrix T, and what couples it to the next step.
struct Tridiagonal
{
  std::vector<double> diagonal, coupling; // the last coupling belongs to the next step

  double largest_eigenvalue() const
  {
    const auto n = static_cast<Eigen::Index>(diagonal.size());
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), n),
                                  Eigen::Map<const Eigen::VectorXd>(coupling.data(), n - 1),
                                  Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[n - 1];
  }

  /// det(x - T) over the product of the couplings.
  double polynomial(const double x) const
  {
    double before = 0., p = 1.;
    for (std::size_t k = 0; k < diagonal.size(); ++k)
    {
      const double next =
          ((x - diagonal[k]) * p - (k > 0 ? coupling[k - 1] : 0.) * before) / coupling[k];
      before = p;
      p      = next;
    }
    return p;
  }

  /// Where, beyond all its roots, the polynomial rises to this value; to rounding.
  double argument_of(const double value) const
  {
    double low = largest_eigenvalue(), high = 2. * low;
    if (!(low > 0.))
      return low; // nothing pulls back, or what does is not a number
    while (polynomial(high) < value)
      high *= 2.;
    for (double middle = 0.5 * (low + high); middle > low && middle < high;
         middle        = 0.5 * (low + high))
      (polynomial(middle) < value ? low : high) = middle;
    return high;
  }
};

/// Lanczos' process, a step at a time.
class Lanczos
{
public:
  explicit Lanczos(Shaker &shaker) : shaker_(shaker), last_(shaker.u.size(), 0.) {}

  /// One force evaluation; returns whether there is more to be found.
  bool step()
  {
    shaker_.respond();
    auto &u = shaker_.u, &a = shaker_.a;
    const double diagonal = shaker_.product(u, a);
    for (std::size_t i = 0; i < last_.size(); ++i)
    {
      a[i] -= diagonal * u[i] + coupling_ * last_[i];
      last_[i] = u[i];
    }
    std::swap(u, a);
    coupling_ = shaker_.normalise();
    found_.diagonal.push_back(diagonal);
    found_.coupling.push_back(coupling_);
    // Forces are linear to the amplitude: a coupling of that size is none.
    return coupling_ > 10. * amplitude * diagonal;
  }
  const Tridiagonal &found() const { return found_; }

private:
  Shaker &shaker_;
  std::vector<double> last_;
  double coupling_ = 0.;
  Tridiagonal found_;
};

/// To the next number of 16 bits, at most 3e-5 above: instruction sets round differently, by 1e-11,
/// and in all but one of a million scenes the bound then does not depend on them.
double rounded_up(const double x)
{
  int exponent;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::ceil(std::ldexp(mantissa, 16)), exponent - 16);
}
} // namespace

FrequencyEstimate frequency_bound(const MPI_Comm communicator, Body &body)
{
  constexpr int most      = 30;   // evaluations: another one gains less than 0.1 % of the step
  constexpr double chance = 0.01; // that an eigenvalue lies beyond
  constexpr double enough = 1.02; // over the eigenvalue: a hundredth of the step
  // What the nonlinearity of the forces may hide, twice to be safe.
  constexpr double blur   = 1. + 4. * amplitude;
  Shaker shaker(communicator, body);
  Lanczos lanczos(shaker);
  const double value = std::sqrt(2. / M_PI * shaker.size()) / chance;
  double bound       = 0.;
  for (int k = 0; k < most; ++k)
  {
    const bool goes_on = lanczos.step();
    bound              = lanczos.found().argument_of(value);
    if (!goes_on || bound < enough * lanczos.found().largest_eigenvalue())
      break;
  }
  return shaker.estimate(rounded_up(blur * bound));
}

FrequencyEstimate largest_frequency(const MPI_Comm communicator, Body &body, const int n_iterations)
{
  Shaker shaker(communicator, body);
  double eigenvalue = 0.;
  for (int iteration = 0; iteration < n_iterations; ++iteration)
  {
    shaker.respond();
    std::swap(shaker.u, shaker.a);
    eigenvalue = shaker.normalise();
  }
  return shaker.estimate(eigenvalue);
}
} // namespace ricochet
