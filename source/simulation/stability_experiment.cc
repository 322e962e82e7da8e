// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/stability_experiment.h"

#include "ricochet/base/exact_sum.h"
#include "ricochet/base/noise.h"
#include "ricochet/base/units.h"
#include "ricochet/coupling/dispersion.h"
#include "ricochet/dynamics/largest_frequency.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace ricochet
{
namespace
{
constexpr int n_parts                = 40;
constexpr double noise               = 1e-6; // of the velocities, in wave speeds: linear [-]
constexpr double runaway             = 1e8;  // still linear, as strains are then 1e-2 at most
constexpr int steps_between_energies = 20;
constexpr int n_power_iterations     = 300; // the measure of all else, so to 0.1 %

/// Slope of a straight line through values at 0, 1, 2 ... by least squares.
double slope(const std::vector<double> &values)
{
  const double n = static_cast<double>(values.size()), mean = 0.5 * (n - 1.);
  double numerator = 0., denominator = 0.;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    numerator += (i - mean) * values[i];
    denominator += (i - mean) * (i - mean);
  }
  return denominator > 0. ? numerator / denominator : 0.;
}

/// The block, the box around it, and its motion.
class Experiment
{
public:
  Experiment(const MPI_Comm communicator, const StabilityParameters &parameters) :
    communicator_(communicator), parameters_(parameters)
  {
    const auto stencil =
        make_stencil(parameters.spacing, parameters.horizon_ratio, parameters.influence);
    const int n       = parameters.coupling.points_per_edge;
    const int layers  = make_zone({1, 1, 1}, stencil, parameters.coupling).slaved_layers();
    const int outside = layers + parameters.margin / n, inside = 2 * parameters.half_width / n;
    const int n_cells = inside + 2 * outside;
    auto zone         = std::make_unique<Zone>(
        make_zone({n_cells, n_cells, n_cells}, stencil, parameters.coupling));
    zone->grow(
        {{{outside, outside, outside}, {outside + inside, outside + inside, outside + inside}}});

    const double E = parameters.youngs_modulus, nu = parameters.poisson_ratio;
    const double K = E / (3. * (1. - 2. * nu)), mu = E / (2. * (1. + nu));
    wave_speed_ = std::sqrt((K + 4. / 3. * mu) / parameters.density);
    const PeridynamicMaterial material{&bond_law("linear peridynamic solid"), parameters.density, K,
                                       mu, std::numeric_limits<double>::infinity()};
    const Lattice::Box box{
        Vector3::Zero(), parameters.spacing, {n * n_cells, n * n_cells, n * n_cells}, false};
    auto points         = std::make_unique<PeridynamicBody>(communicator, 0, box, stencil, material,
                                                    Lattice::Mask{}, nullptr, zone.get());
    zone_               = zone.get();
    points_             = points.get();
    options_.coupling   = parameters.coupling;
    options_.quadrature = parameters.full_quadrature ? Quadrature::full : Quadrature::one_point;
    options_.hourglass_coefficient = parameters.hourglass_coefficient;
    far_ =
        std::make_unique<CoupledPlate>(communicator, std::move(zone), std::move(points), options_);
    const auto &lattice = points_->lattice();
    lattice.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          if (lattice.free(p))
            free_.push_back(p);
        });
  }

  CoupledPlate &plate() { return *far_; }
  double predicted_step() const { return predicted_time_step(*points_, &options_).step(); }
  double measured_step()
  {
    return 2. /
           std::sqrt(largest_frequency(communicator_, *far_, n_power_iterations).squared_frequency);
  }

  void excite()
  {
    const double speed = noise * wave_speed_, shift = parameters_.jitter * parameters_.spacing;
    auto &a        = points_->state().arrays;
    auto &elements = far_->elements();
    for (const std::ptrdiff_t p : free_)
    {
      const auto &lattice = points_->lattice();
      const Vector3 X     = lattice.reference_position(lattice.coordinates(p));
      const Vector3 place = X / parameters_.spacing;
      for (int d = 0; d < 3; ++d)
      {
        a.velocity[d][p] = speed * noise_at(place, d);
        a.position[d][p] = X[d] + shift * noise_at(place, 3 + d);
      }
    }
    auto velocity = elements.velocity();
    for (int node = 0; node < elements.mesh().n_owned_nodes(); ++node)
    {
      const Vector3 X     = elements.mesh().reference_position(node);
      const Vector3 place = X / parameters_.spacing;
      for (int d = 0; d < 3 && elements.mass(node) > 0.; ++d)
      {
        velocity[3 * node + d]            = speed * noise_at(place, d);
        elements.position()[3 * node + d] = X[d] + shift * noise_at(place, 3 + d);
      }
    }
    elements.set_velocity(velocity);
    far_->interpolate_to_slaved_points();
  }

  void evaluate(const bool energy)
  {
    far_->update_ghosts();
    far_->compute_internal_forces({energy});
    far_->complete_forces();
  }

  void advance(const double dt) { far_->advance(dt, dt); }

  /// 1/2 m v^2 with lumped masses; a measure, also where the scheme conserves nothing [J].
  double kinetic_energy() const
  {
    const auto &a        = points_->state().arrays;
    const auto &elements = far_->elements();
    ExactSum twice;
    for (const std::ptrdiff_t p : free_)
      for (const double *v : a.velocity)
        twice.add(points_->point_mass() * v[p] * v[p]);
    for (int i = 0; i < 3 * elements.mesh().n_owned_nodes(); ++i)
      twice.add(elements.mass(i / 3) * elements.velocity()[i] * elements.velocity()[i]);
    return 0.5 * total(communicator_, twice);
  }

  /// Root mean square of the hourglass displacements sum Gamma_a u_a of all elements [m].
  double hourglass_displacement() const
  {
    const auto &elements = far_->elements();
    ExactSum squares;
    double n = 0.;
    for (std::size_t e = 0; e < elements.mesh().elements().size(); ++e)
    {
      if (!elements.is_active(static_cast<int>(e)))
        continue;
      const auto &nodes = elements.mesh().elements()[e].nodes;
      for (const int axes : {6, 5, 3, 7})
        for (int d = 0; d < 3; ++d)
        {
          double q = 0.;
          for (int a = 0; a < 8; ++a)
          {
            // The product of the corner's coordinates -1 or 1 along these axes; X drops out.
            const int minus = axes & ~a;
            const int odd   = (minus ^ (minus >> 1) ^ (minus >> 2)) & 1;
            q += (odd ? -1. : 1.) * elements.position()[3 * nodes[a] + d];
          }
          squares.add(q * q);
          n += 1.;
        }
    }
    return std::sqrt(total(communicator_, squares) / sum(n));
  }

  double energy(const double dt) const { return far_->energies(dt).held(); }
  std::int64_t n_points() const { return static_cast<std::int64_t>(sum(double(free_.size()))); }
  std::int64_t n_elements() const
  {
    return far_->elements().mesh().n_global_elements() - zone_->n_free_cells();
  }

private:
  double sum(double value) const
  {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return value;
  }

  MPI_Comm communicator_;
  StabilityParameters parameters_;
  CoupledPlateOptions options_;
  std::unique_ptr<CoupledPlate> far_;
  const Zone *zone_;        // of the plate
  PeridynamicBody *points_; // likewise
  std::vector<std::ptrdiff_t> free_;
  double wave_speed_; // c_P [m/s]
};

/// Largest kinetic energies of parts of the run that are equally long, and how they grow.
void find_growth(const std::vector<double> &kinetic, StabilityResult &result)
{
  const std::size_t length = std::max<std::size_t>(1, kinetic.size() / n_parts);
  std::vector<double> envelope;
  for (std::size_t first = 0; first + length <= kinetic.size(); first += length)
    envelope.push_back(
        std::log(*std::max_element(kinetic.begin() + first, kinetic.begin() + first + length)));
  const std::vector<double> tail(envelope.begin() + envelope.size() / 2, envelope.end());
  result.growth          = std::exp(tail.back() - tail.front());
  result.growth_per_step = slope(tail) / static_cast<double>(length);
  result.growth_per_us   = result.growth_per_step / (result.time_step / units::us);
}

void judge(const StabilityLimits &limits, StabilityResult &result)
{
  result.verdict = StabilityVerdict::unstable;
  // Growth may end where strains are no longer small; the rise stays.
  if (result.ran_away || result.rise > limits.rise || result.growth > limits.growth)
    result.reason = "kinetic energy grows";
  else if (result.hourglass_growth > limits.hourglass)
    result.reason = "hourglass modes drift";
  else
  {
    result.verdict = StabilityVerdict::inaccurate;
    if (!(result.patch.strain_error <= limits.strain_error))
      result.reason = "strain error";
    else if (result.energy_drift > limits.energy_drift)
      result.reason = "energy drift";
    else
      result.verdict = StabilityVerdict::stable;
  }
}
} // namespace

const char *verdict_name(const StabilityVerdict verdict)
{
  return verdict == StabilityVerdict::stable       ? "stable"
         : verdict == StabilityVerdict::inaccurate ? "inaccurate"
                                                   : "unstable";
}

StabilityResult run_stability_experiment(const MPI_Comm communicator,
                                         const StabilityParameters &parameters,
                                         const StabilityLimits &limits)
{
  Experiment experiment(communicator, parameters);
  StabilityResult result{};
  result.n_points            = experiment.n_points();
  result.n_elements          = experiment.n_elements();
  result.smallest_eigenvalue = experiment.plate().calibration().smallest_eigenvalue;
  result.patch               = patch_test(communicator, experiment.plate());
  result.predicted_step      = experiment.predicted_step();
  result.measured_step       = experiment.measured_step();
  const double limit =
      parameters.limit == StepLimit::measured ? result.measured_step : result.predicted_step;
  const double dt  = parameters.time_step * limit;
  result.time_step = dt;

  experiment.excite();
  std::vector<double> kinetic;
  double first_energy = 0., hourglass = 0.;
  for (int step = 0; step <= parameters.n_steps && !result.ran_away; ++step)
  {
    const bool energy_due = step % steps_between_energies == 0 || step == parameters.n_steps;
    experiment.evaluate(energy_due);
    if (energy_due)
    {
      const double energy = experiment.energy(dt);
      if (step == 0)
        first_energy = energy;
      result.energy_drift = std::max(result.energy_drift, std::abs(energy / first_energy - 1.));
    }
    kinetic.push_back(experiment.kinetic_energy());
    result.rise     = std::max(result.rise, kinetic.back() / first_energy);
    result.ran_away = !(kinetic.back() < runaway * first_energy);
    result.n_steps  = step;
    if (step == parameters.n_steps / 2)
      hourglass = experiment.hourglass_displacement();
    if (!result.ran_away)
      experiment.advance(dt);
  }
  result.hourglass_growth =
      hourglass > 0. && !result.ran_away ? experiment.hourglass_displacement() / hourglass : 1.;
  if (!std::isfinite(kinetic.back()))
    kinetic.pop_back();
  find_growth(kinetic, result);
  judge(limits, result);
  return result;
}
} // namespace ricochet
