// SPDX-License-Identifier: LGPL-2.1-or-later
// A projectile of points in front and elements behind, alone: its conserved quantities, waves
// through the interface, its lowest modes.
#include "ricochet/base/exceptions.h"
#include "ricochet/coupling/coupled_projectile_body.h"
#include "ricochet/dynamics/largest_frequency.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "ricochet/materials/bond_laws.h"
#include "support/hexahedra.h"
#include "support/random.h"
#include "support/verification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace ricochet::tests
{
namespace
{
const BodyOfRevolution core({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});
const double all   = std::numeric_limits<double>::infinity();
constexpr double E = 202e9, density = 7850.;
const double c = std::sqrt(E / density); // of bars [m/s]

HexSolid mesh_of(const BodyOfRevolution &shape, const int refinement, const bool half)
{
  const HexSolid whole = revolved_hexes(shape, refinement);
  return half ? upper_half(whole, 1e-9) : whole;
}

CoupledProjectileBody::Parameters parameters(const HexSolid &mesh, const double spacing,
                                             const double points_length, const bool half,
                                             const bool corrected = true)
{
  const auto m = steel();
  return {spacing,
          m.density * volume(mesh),
          &bond_law("linear peridynamic solid"),
          m.bulk_modulus,
          m.shear_modulus,
          half,
          points_length,
          corrected};
}

double step_of(CoupledProjectileBody &body)
{
  return 0.8 * 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, body).squared_frequency);
}

struct Momenta
{
  Vector3 linear = Vector3::Zero(), angular = Vector3::Zero();
};

Momenta momenta(const CoupledProjectileBody &body)
{
  Momenta sum;
  for (const auto &point : body.mass_points())
  {
    const Vector3 x(*point.position[0], *point.position[1], *point.position[2]),
        p = point.mass * Vector3(*point.velocity[0], *point.velocity[1], *point.velocity[2]);
    sum.linear += p;
    sum.angular += x.cross(p);
  }
  return sum;
}

TEST(CoupledProjectileBody, SpinningProjectileKeepsEnergyAndMomenta)
{
  const HexSolid mesh = mesh_of(core, 1, false);
  CoupledProjectileBody body(core, mesh, parameters(mesh, 0.75e-3, 10.23e-3, false));
  const double dt = step_of(body);
  // As the body of elements in test_elastic_body.cc; besides, it rings.
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.6, Vector3(1., 1., 0.5).normalized()));
  const Vector3 velocity(600., 50., -300.), spin(3000., -2e4, 1e4);
  for (const auto &point : body.mass_points())
  {
    const Vector3 arm = turn * point.reference;
    const Vector3 v   = velocity + spin.cross(arm) +
                      turn * Vector3(5. * std::cos(150. * point.reference.x()), 0., 0.);
    for (int d = 0; d < 3; ++d)
    {
      *point.position[d] = arm[d];
      *point.velocity[d] = v[d];
    }
  }
  body.interpolate_to_slaved_points();
  double low = 1e300, high = 0.;
  Momenta first, last;
  for (int step = 0; step < 10000; ++step)
  {
    const bool look = step % 10 == 0;
    body.update_ghosts();
    body.compute_internal_forces({look});
    if (step > 0 && look)
    {
      double total = body.energies(0.).strain;
      for (const auto &point : body.mass_points())
        for (int d = 0; d < 3; ++d)
          total +=
              0.5 * *point.velocity[d] * (point.mass * *point.velocity[d] + dt * *point.force[d]);
      low  = std::min(low, total);
      high = std::max(high, total);
    }
    last = momenta(body);
    if (step == 1)
      first = last;
    body.advance(dt, dt);
  }
  verify_at_most("V3", "energy of a spinning coupled projectile", (high - low) / high, 1e-5);
  verify_at_most("V3", "linear momentum of a spinning coupled projectile",
                 (last.linear - first.linear).norm() / first.linear.norm(), 1e-12);
  verify_at_most("V3", "angular momentum of a spinning coupled projectile",
                 (last.angular - first.angular).norm() / first.angular.norm(), 1e-10);
}

TEST(CoupledProjectileBody, ForcesAreMinusTheGradientOfTheEnergy)
{
  const HexSolid mesh = mesh_of(core, 1, true);
  CoupledProjectileBody body(core, mesh, parameters(mesh, 0.75e-3, 10.23e-3, true));
  Random random(3);
  std::vector<Vector3> direction;
  const auto place = [&](const double t)
  {
    for (std::size_t i = 0; i < direction.size(); ++i)
      for (int d = 0; d < 3; ++d)
        if (const auto &point = body.mass_points()[i]; point.mobility[d] > 0.)
          *point.position[d] = point.reference[d] + t * direction[i][d];
    body.interpolate_to_slaved_points();
    body.update_ghosts();
    body.compute_internal_forces({true});
    return body.energies(0.).strain;
  };
  for (std::size_t i = 0; i < body.mass_points().size(); ++i)
    direction.emplace_back(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
  const double t = 1e-5, step = 1e-9;
  const double slope = (place(t + step) - place(t - step)) / (2. * step);
  place(t);
  double power = 0.;
  for (std::size_t i = 0; i < direction.size(); ++i)
    for (int d = 0; d < 3; ++d)
      if (const auto &point = body.mass_points()[i]; point.mobility[d] > 0.)
        power -= *point.force[d] * direction[i][d];
  EXPECT_NEAR(slope, power, 1e-7 * power);
}

TEST(CoupledProjectileBody, MassIsThatOfTheMeshAndTurningStressesNothing)
{
  for (const bool half : {false, true})
  {
    const HexSolid mesh = mesh_of(core, 2, half);
    CoupledProjectileBody body(core, mesh, parameters(mesh, 0.75e-3, 12e-3, half));
    double mass = 0.;
    for (const auto &point : body.mass_points())
      mass += point.mass;
    EXPECT_NEAR(mass, body.mass(), 1e-12 * mass);
    // The nearest layer of elements, which are 0.83 mm long.
    EXPECT_NEAR(core.tip_position() - body.interface(), 12e-3, 0.42e-3);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.8, Vector3::UnitY()));
    for (const auto &point : body.mass_points())
      for (int d = 0; d < 3; ++d)
        *point.position[d] = (turn * point.reference)[d];
    body.interpolate_to_slaved_points();
    body.update_ghosts();
    body.compute_internal_forces({false});
    // In units of what a strain of one does to a node.
    double largest = 0.;
    for (const auto &point : body.mass_points())
      for (int d = 0; d < 3; ++d)
        largest = std::max(largest, std::abs(*point.force[d]));
    EXPECT_LT(largest, 1e-11 * E * 0.75e-3 * 0.75e-3);
  }
}

/// A bar of elements behind, points in front, and the same all of elements. A pulse of the velocity
/// v = (1 + cos(2 pi s/width))/2 runs along it, with the strain -v/c and the contraction of a bar.
class Bar
{
public:
  static constexpr double length = 120e-3, start = 30e-3, interface = 60e-3;

  Bar(const double spacing, const int refinement, const double width, const bool corrected = true) :
    width_(width), mesh_(mesh_of(shape(), refinement, true)),
    body_(shape(), mesh_, parameters(mesh_, spacing, length - interface, true, corrected)),
    elements_(mesh_, steel(), true)
  {
    dt_ =
        std::min(step_of(body_),
                 0.8 * 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, elements_).squared_frequency));
    for (const auto &point : body_.mass_points())
      place(point.reference, point.position, point.velocity, point.mobility);
    body_.interpolate_to_slaved_points();
    for (int node = 0; node < elements_.n_nodes(); ++node)
    {
      std::array<double *, 3> x, v;
      Vector3 mobility;
      for (int d = 0; d < 3; ++d)
      {
        x[d]        = &elements_.position()[3 * node + d];
        v[d]        = &elements_.velocity()[3 * node + d];
        mobility[d] = elements_.inverse_mass(3 * node + d);
      }
      place(mesh_.nodes[node], x, v, mobility);
    }
    for (double t = 0.; t < 60e-3 / c; t += dt_)
    {
      body_.update_ghosts();
      body_.compute_internal_forces({false});
      body_.advance(dt_, dt_);
      elements_.compute_internal_forces({false});
      elements_.advance(dt_, dt_);
    }
  }

  /// Energy that runs back from the interface, in parts of the pulse's: what differs from the bar
  /// of elements where the pulse has left.
  double reflected() const
  {
    const auto with = means(body_.mass_points(), body_.interface()), without = means_of_elements();
    double difference = 0., all_of_it = 0.;
    for (const auto &[x, layer] : without)
    {
      all_of_it += layer.mass * std::pow(layer.momentum / layer.mass, 2);
      if (x < std::lround(1e6 * (interface - 0.5 * width_)))
        difference +=
            layer.mass *
            std::pow(with.at(x).momentum / with.at(x).mass - layer.momentum / layer.mass, 2);
    }
    return difference / all_of_it;
  }

  /// How much farther the pulse's centre has come than in the bar of elements, in parts of its way
  /// through the points.
  double lead_of_points() const
  {
    return (centre(means(body_.mass_points(), 1.)) - centre(means_of_elements())) / 30e-3;
  }

private:
  struct Layer
  {
    double mass = 0., momentum = 0.;
  };
  using Layers = std::map<long, Layer>; // by the distance from the base [um]

  static BodyOfRevolution shape()
  {
    return BodyOfRevolution({NoseShape::flat, 6.17e-3, length, 0.});
  }

  Vector3 displacement(const Vector3 &X, const double time) const
  {
    const double s      = (X.x() - shape().base_position() - start - c * time) / width_;
    const double inside = std::clamp(s, -0.5, 0.5);
    const double v      = std::abs(s) < 0.5 ? 0.5 * (1. + std::cos(2. * M_PI * s)) : 0.;
    const double behind = 0.5 * inside + std::sin(2. * M_PI * inside) / (4. * M_PI);
    return {width_ / c * (0.25 - behind), 0.3 * v / c * X.y(), 0.3 * v / c * X.z()};
  }

  void place(const Vector3 &X, const std::array<double *, 3> &position,
             const std::array<double *, 3> &velocity, const Vector3 &mobility) const
  {
    const Vector3 u = displacement(X, 0.), before = displacement(X, -dt_);
    for (int d = 0; d < 3; ++d)
    {
      *position[d] = X[d] + u[d];
      *velocity[d] = mobility[d] > 0. ? (u[d] - before[d]) / dt_ : 0.;
    }
  }

  Layers means(const std::vector<CoupledProjectileBody::MassPoint> &points, const double end) const
  {
    Layers layers;
    for (const auto &point : points)
      if (point.reference.x() < end)
        add(layers, point.reference.x(), point.mass, *point.velocity[0]);
    return layers;
  }
  Layers means_of_elements() const
  {
    Layers layers;
    for (int node = 0; node < elements_.n_nodes(); ++node)
      add(layers, mesh_.nodes[node].x(), elements_.node_mass(node), elements_.velocity()[3 * node]);
    return layers;
  }
  static void add(Layers &layers, const double x, const double mass, const double velocity)
  {
    auto &layer = layers[std::lround(1e6 * (x - shape().base_position()))];
    layer.mass += mass;
    layer.momentum += mass * velocity;
  }

  static double centre(const Layers &layers) // of the momentum beyond the interface [m]
  {
    double sum = 0., first = 0.;
    for (const auto &[x, layer] : layers)
      if (1e-6 * x > interface)
      {
        sum += layer.momentum;
        first += 1e-6 * x * layer.momentum;
      }
    return first / sum;
  }

  double width_, dt_;
  HexSolid mesh_;
  CoupledProjectileBody body_;
  HexahedralBody elements_;
};

TEST(CoupledProjectileBody, PulsesPassTheInterface)
{
  // What the list asks of the plates' interface (V7), by the width of the pulse in horizons of
  // three spacings; whether elements are as large as two cells of the lattice or smaller than
  // points.
  const struct
  {
    double spacing;
    int refinement;
  } grids[] = {{0.75e-3, 1}, {0.75e-3, 2}, {1e-3, 2}, {0.5e-3, 2}};
  for (const auto &grid : grids)
    for (const auto &[horizons, limit] : {std::pair(4., 2e-2), {6., 2e-3}, {8., 8e-4}})
    {
      const Bar bar(grid.spacing, grid.refinement, horizons * 3. * grid.spacing);
      const double reflected = bar.reflected();
      std::printf("dx %.2f mm, refinement %d, %.0f horizons: reflected %.1e, lead %.4f\n",
                  1e3 * grid.spacing, grid.refinement, horizons, reflected, bar.lead_of_points());
      EXPECT_LT(reflected, limit);
    }
}

TEST(CoupledProjectileBody, PointsCarryPulsesAsFastAsElementsWithTheirSurfaceCorrected)
{
  // A pulse of four diameters, to 1 % as V7 asks of waves.
  const Bar bar(0.75e-3, 2, 24e-3), uncorrected(0.75e-3, 2, 24e-3, false);
  EXPECT_NEAR(bar.lead_of_points(), 0., 0.01);
  EXPECT_LT(uncorrected.lead_of_points(), -0.03);
  for (const Bar *one : {&bar, &uncorrected})
    std::printf("pulse of four diameters%s: reflected %.1e, lead %.4f\n",
                one == &bar ? "" : ", not corrected", one->reflected(), one->lead_of_points());
}

/// Frequency of the core's lowest mode along its axis (0) or across (2) [Hz]. It starts with a
/// velocity of about that shape, whose share in the motion then changes sign twice a period.
template <class Step>
double frequency(const std::vector<CoupledProjectileBody::MassPoint> &points, const int axis,
                 const double dt, Step &&step)
{
  const auto shape = [&](const double x)
  { return axis == 0 ? std::sin(M_PI * x / core.shape().length) : x * x; };
  // Without the rigid motions.
  double mass = 0., first = 0., sum = 0.;
  for (const auto &point : points)
  {
    mass += point.mass;
    first += point.mass * point.reference.x();
    sum += point.mass * shape(point.reference.x());
  }
  double moment = 0., turn = 0.;
  for (const auto &point : points)
  {
    const double arm = point.reference.x() - first / mass;
    moment += point.mass * arm * arm;
    turn += point.mass * arm * shape(point.reference.x());
  }
  std::vector<double> mode;
  for (const auto &point : points)
    mode.push_back(shape(point.reference.x()) - sum / mass -
                   (axis == 0 ? 0. : turn / moment * (point.reference.x() - first / mass)));
  for (std::size_t i = 0; i < points.size(); ++i)
    *points[i].velocity[axis] = 0.1 * mode[i];
  int crossings = 0;
  double begin = 0., end = 0., before = 1.;
  for (int i = 0; crossings < 9 && i < 100000; ++i)
  {
    step();
    double now = 0.;
    for (std::size_t p = 0; p < points.size(); ++p)
      now += points[p].mass * mode[p] * *points[p].velocity[axis];
    if (now * before < 0.)
    {
      end   = (i + before / (before - now)) * dt;
      begin = crossings++ == 0 ? end : begin;
    }
    before = now;
  }
  return 0.5 * (crossings - 1) / (end - begin);
}

/// Of the projectile of elements at refinement 2 [Hz].
double elements_frequency(const HexSolid &mesh, const int axis)
{
  HexahedralBody elements(mesh, steel(), true);
  const double dt =
      0.8 * 2. / std::sqrt(frequency_bound(MPI_COMM_SELF, elements).squared_frequency);
  std::vector<CoupledProjectileBody::MassPoint> nodes;
  for (int node = 0; node < elements.n_nodes(); ++node)
    nodes.push_back({mesh.nodes[node],
                     elements.node_mass(node),
                     Vector3::Zero(),
                     {},
                     {&elements.velocity()[3 * node], &elements.velocity()[3 * node + 1],
                      &elements.velocity()[3 * node + 2]},
                     {}});
  return frequency(nodes, axis, dt,
                   [&]
                   {
                     elements.compute_internal_forces({false});
                     elements.advance(dt, dt);
                   });
}

double frequency_of(CoupledProjectileBody &body, const int axis)
{
  const double dt = step_of(body);
  return frequency(body.mass_points(), axis, dt,
                   [&]
                   {
                     body.update_ghosts();
                     body.compute_internal_forces({false});
                     body.advance(dt, dt);
                   });
}

/// In parts of that of the projectile of elements at refinement 2, along (0) or across (2) the
/// axis.
double relative_frequency(const int axis, const double spacing, const double points_length,
                          const bool corrected = true)
{
  const HexSolid mesh = mesh_of(core, 2, true);
  CoupledProjectileBody body(core, mesh, parameters(mesh, spacing, points_length, true, corrected));
  const double ratio = frequency_of(body, axis) / elements_frequency(mesh, axis);
  std::printf("%s, dx %.2f mm, points %.2f mm%s: %.4f of the elements' frequency\n",
              axis == 0 ? "along" : "across", 1e3 * spacing, 1e3 * points_length,
              corrected ? "" : ", not corrected", ratio);
  return ratio;
}

TEST(CoupledProjectileBody, RingsAsTheProjectileOfElements)
{
  // 3 %, as V11 asks of the coupled cantilever. With one and a half times the nose the interface
  // lies where the shank bends most.
  for (const int axis : {0, 2})
  {
    EXPECT_NEAR(relative_frequency(axis, 0.75e-3, 10.23e-3), 1., 0.03);
    EXPECT_NEAR(relative_frequency(axis, 0.75e-3, 15e-3), 1., 0.03);
    EXPECT_NEAR(relative_frequency(axis, 0.5e-3, 10.23e-3), 1., 0.03);
    EXPECT_NEAR(relative_frequency(axis, 0.5e-3, all), 1., 0.03);
  }
  EXPECT_NEAR(relative_frequency(0, 0.75e-3, all), 1., 0.03);
}

TEST(CoupledProjectileBody, EightPointsAcrossBendFivePerCentTooSlowlyAndFifteenWithoutCorrection)
{
  // Missed: 3 % is asked.
  EXPECT_NEAR(relative_frequency(2, 0.75e-3, all), 0.954, 0.002);
  EXPECT_NEAR(relative_frequency(2, 0.75e-3, all, false), 0.847, 0.002);
  EXPECT_NEAR(relative_frequency(0, 0.75e-3, all, false), 0.911, 0.002);
}

TEST(CoupledProjectileBody, StepFromTheFrequencyBoundIsStableAndALongerOneIsNot)
{
  const HexSolid mesh = mesh_of(core, 1, false);
  for (const double share : {1., 1.05})
  {
    CoupledProjectileBody body(core, mesh, parameters(mesh, 0.75e-3, 10.23e-3, false));
    const double dt = share / 0.8 * step_of(body);
    Random random(17);
    for (const auto &point : body.mass_points())
      for (double *v : point.velocity)
        *v = 1e-6 * random.uniform();
    for (int step = 0; step < 2000; ++step)
    {
      body.update_ghosts();
      body.compute_internal_forces({false});
      body.advance(dt, dt);
    }
    double kinetic = 0.;
    for (const auto &point : body.mass_points())
      for (const double *v : point.velocity)
        kinetic += point.mass * *v * *v;
    const bool grew = !(kinetic < 1e-9);
    EXPECT_EQ(grew, share > 1.) << kinetic;
  }
}

TEST(CoupledProjectileBody, TakesAnotherHorizon)
{
  // With four spacings instead of three points overlap the elements by two layers more, bonds are
  // longer, and the body is as stiff as before.
  const HexSolid mesh = mesh_of(core, 2, true);
  auto three = parameters(mesh, 0.75e-3, 10.23e-3, true), four = three;
  four.horizon_ratio = 4.;
  CoupledProjectileBody shorter(core, mesh, three), longer(core, mesh, four);
  EXPECT_NEAR(shorter.overlap().length, 4. * 0.75e-3, 1e-12);
  EXPECT_NEAR(longer.overlap().length, 8. * 0.75e-3, 1e-12);
  EXPECT_LT(longer.overlap().ghost, 2. * shorter.overlap().ghost);
  EXPECT_NEAR(frequency_of(longer, 0) / elements_frequency(mesh, 0), 1., 0.03); // as above
}

TEST(CoupledProjectileBody, RefusesWhatDoesNotFit)
{
  const HexSolid mesh = mesh_of(core, 2, true);
  const auto refused  = [&](const double spacing, const double points_length)
  {
    try
    {
      CoupledProjectileBody(core, mesh, parameters(mesh, spacing, points_length, true));
    }
    catch (const InputError &error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refused(3.2e-3, all).find("too coarse"), std::string::npos);
  EXPECT_NE(refused(0.75e-3, 25.5e-3).find("too short"), std::string::npos);
  EXPECT_NE(refused(0.75e-3, 27.5e-3).find("no element"), std::string::npos);
  EXPECT_EQ(refused(0.75e-3, 20e-3), "");
}
} // namespace
} // namespace ricochet::tests
