// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/element_body.h"
#include "support/verification.h"

#include "ricochet/base/exceptions.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
enum class Kind
{
  one_point,
  full,
  own_tensors
};
constexpr Kind kinds[] = {Kind::one_point, Kind::full, Kind::own_tensors};

FiniteElementBody::Options options_for(const Kind kind)
{
  FiniteElementBody::Options options;
  options.quadrature = kind == Kind::full ? Quadrature::full : Quadrature::one_point;
  return options;
}

/// About every third element gets this tensor at all Gauss points; which ones is even in y.
void give_tensor(FiniteElementBody &body, const Matrix6 &C)
{
  std::vector<ElementStiffness> stiffness;
  const auto &elements = body.mesh().elements();
  for (std::size_t e = 0; e < elements.size(); ++e)
    if (const Vector3 X = body.mesh().centre(elements[e]) / elements[e].edge;
        (std::lround(10. + X.x()) + std::lround(std::abs(X.y()) - 0.5) + std::lround(X.z())) % 3 ==
        0)
    {
      stiffness.push_back({static_cast<int>(e), {}});
      stiffness.back().tensors.fill(upper_triangle(C));
    }
  body.set_stiffness(stiffness);
}

Matrix6 own_tensor()
{
  const auto m = pmma();
  return isotropic_tensor(lambda(m), m.shear_modulus);
}

std::unique_ptr<FiniteElementBody> make_body(const Kind kind, const HexMesh::Box &box)
{
  auto body = std::make_unique<FiniteElementBody>(MPI_COMM_SELF, box, pmma(), options_for(kind));
  if (kind == Kind::own_tensors)
    give_tensor(*body, own_tensor());
  return body;
}

bool inside(const HexMesh &mesh, const Vector3 &X)
{
  const auto &box    = mesh.box();
  const Vector3 high = box.corner + box.edge * Vector3(box.n[0], box.n[1], box.n[2]);
  const double tiny  = 1e-9 * box.edge;
  return (X.array() > box.corner.array() + tiny).all() && (X.array() < high.array() - tiny).all();
}

const char *name_of(const Kind kind)
{
  return kind == Kind::one_point ? "OnePoint" : kind == Kind::full ? "Full" : "OwnTensors";
}

class ElementBodyOfAnyKind : public testing::TestWithParam<Kind>
{
};

INSTANTIATE_TEST_SUITE_P(Kinds, ElementBodyOfAnyKind, testing::ValuesIn(kinds),
                         [](const auto &info) { return name_of(info.param); });

TEST_P(ElementBodyOfAnyKind, HasNoForceInTheReferenceConfiguration)
{
  const auto body = make_body(GetParam(), refined_box());
  deform(*body, [](const Vector3 &X) { return X; });
  const double M = p_wave_modulus(pmma()), h = body->mesh().box().edge;
  verify_at_most("V2", "force in elements at rest, with hanging nodes [Mh²]",
                 largest_force(*body) / (M * h * h), 1e-12);
  EXPECT_LT(body->energies(0.).strain, 1e-24 * M * h * h * h * 60.);
}

TEST_P(ElementBodyOfAnyKind, HasNoForceWhenTurnedByARightAngleAndMovedAway)
{
  const auto body = make_body(GetParam(), refined_box());
  // About an axis that maps no cube onto itself.
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(M_PI / 2., Vector3(1., 2., 3.).normalized()).toRotationMatrix();
  deform(*body, [&](const Vector3 &X) -> Vector3 { return R * X + Vector3(1e-3, -2e-3, 3e-3); });
  const double M = p_wave_modulus(pmma()), h = body->mesh().box().edge;
  verify_at_most("V2", "force in elements that were turned by 90° and shifted [Mh²]",
                 largest_force(*body) / (M * h * h), 1e-12);
  EXPECT_LT(body->energies(0.).hourglass, 1e-24 * M * h * h * h * 60.);
}

TEST_P(ElementBodyOfAnyKind, UniformStrainOnARefinedMeshGivesExactStressAndNoForceInside)
{
  const auto body = make_body(GetParam(), refined_box());
  const auto m    = pmma();
  // Finite strain and rotation; any numbers of that size.
  Eigen::Matrix3d F;
  F << 1.02, 0.01, -0.03, 0.04, 0.99, 0.02, 0.01, -0.02, 1.03;
  deform(*body, [&](const Vector3 &X) -> Vector3 { return F * X; });
  const Eigen::Matrix3d E = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d S =
      lambda(m) * E.trace() * Eigen::Matrix3d::Identity() + 2. * m.shear_modulus * E;
  const double energy_density = 0.5 * (S * E).trace();
  for (std::size_t e = 0; e < body->mesh().elements().size(); ++e)
  {
    const double edge = body->mesh().elements()[e].edge;
    EXPECT_LT((body->deformation_gradient(e) - F).norm(), 1e-14);
    EXPECT_LT((body->stress(e) - S).norm(), 1e-12 * S.norm()); // strains of 1e-2 from F of 1
    EXPECT_NEAR(body->strain_energy(e), energy_density * std::pow(edge, 3),
                1e-12 * energy_density * std::pow(edge, 3));
  }
  const double scale = S.norm() * std::pow(body->mesh().box().edge, 2);
  int n_inside       = 0;
  for (int node = 0; node < body->mesh().n_owned_nodes(); ++node)
  {
    const Vector3 X = body->mesh().reference_position(node);
    if (inside(body->mesh(), X))
    {
      ++n_inside;
      EXPECT_LT(at(body->force(), node).norm(), 1e-12 * scale);
    }
  }
  EXPECT_GT(n_inside, 24); // the coarse mesh alone has 4 x 3 x 2
}

TEST_P(ElementBodyOfAnyKind, SurfaceNodesCarryTheTractions)
{
  // One size of cubes: the force of a node is F S N times its share of each face, here taken from
  // the formula of the patch test, f_a = F S n_a with n_a the sum of outward area vectors.
  const double h  = 1e-3;
  const auto body = make_body(GetParam(), {Vector3::Zero(), h, {3, 2, 4}, false, {}});
  const auto m    = pmma();
  Eigen::Matrix3d F;
  F << 0.98, 0.03, 0.01, -0.02, 1.01, 0.02, 0.01, -0.04, 1.02;
  deform(*body, [&](const Vector3 &X) -> Vector3 { return F * X; });
  const Eigen::Matrix3d E = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d S =
      lambda(m) * E.trace() * Eigen::Matrix3d::Identity() + 2. * m.shear_modulus * E;
  for (int node = 0; node < body->mesh().n_owned_nodes(); ++node)
  {
    const Vector3 X = body->mesh().reference_position(node) / h;
    Vector3 side = Vector3::Zero(), width = Vector3::Ones();
    for (int d = 0; d < 3; ++d)
    {
      const double n = body->mesh().box().n[d];
      side[d]        = X[d] < 0.5 ? -1. : X[d] > n - 0.5 ? 1. : 0.;
      width[d]       = side[d] == 0. ? 1. : 0.5;
    }
    Vector3 area = h * h * side;
    for (int d = 0; d < 3; ++d)
      area[d] *= width[(d + 1) % 3] * width[(d + 2) % 3];
    // The body pulls its surface inwards: minus the traction that would hold it.
    EXPECT_LT((at(body->force(), node) + F * S * area).norm(), 1e-12 * S.norm() * h * h);
  }
}

TEST_P(ElementBodyOfAnyKind, ForceIsMinusTheGradientOfTheEnergyOnARefinedMesh)
{
  const auto body = make_body(GetParam(), refined_box());
  if (GetParam() == Kind::own_tensors)
  {
    Random random(4);
    give_tensor(*body, random_tensor(random, 1e9));
  }
  const double h = 0.25e-3; // the smallest edge
  const auto x   = [&](const Vector3 &X, const double step) -> Vector3
  { return X + 0.2 * h * noise_at(X, 1e-3) + step * h * noise_at(X, 0.37e-3); };
  const auto energy = [&](const double step)
  {
    deform(*body, [&](const Vector3 &X) { return x(X, step); });
    const auto e = body->energies(0.);
    return e.strain + e.hourglass;
  };
  // Exact for polynomials of degree four, which this energy is; hanging nodes move with their
  // masters and have no force of their own.
  const double s = 0.3;
  const double slope =
      (8. * (energy(s) - energy(-s)) - (energy(2. * s) - energy(-2. * s))) / (12. * s);
  energy(0.);
  double power = 0., scale = 0.;
  for (int node = 0; node < body->mesh().n_owned_nodes(); ++node)
  {
    const Vector3 X     = body->mesh().reference_position(node);
    const double change = -at(body->force(), node).dot(h * noise_at(X, 0.37e-3));
    power += change;
    scale += std::abs(change);
  }
  EXPECT_NEAR(slope, power, 1e-12 * scale);
  EXPECT_GT(std::abs(power), 1e-3 * scale);
  for (const int node : body->mesh().hanging_nodes().node)
    EXPECT_EQ(at(body->force(), node), Vector3(Vector3::Zero()));
}

TEST_P(ElementBodyOfAnyKind, HalfABodyWithAMirrorPlaneMovesLikeTheWhole)
{
  const double h = 1e-3;
  const HexMesh::Region region{Vector3(0., -1e-3, 0.), Vector3(1e-3, 1e-3, 1e-3), 1};
  auto half       = make_body(GetParam(), {Vector3::Zero(), h, {3, 2, 2}, true, {region}});
  auto whole      = make_body(GetParam(), {Vector3(0., -2e-3, 0.), h, {3, 4, 2}, false, {region}});
  // Odd in y across the plane, even otherwise.
  const auto push = [&](const Vector3 &X) -> Vector3
  {
    const Vector3 noise = noise_at(Vector3(X.x(), X.y() * X.y() / h, X.z()), 1e-3);
    return X + 0.05 * h * Vector3(noise.x(), noise.y() * X.y() / h, noise.z());
  };
  const double dt = 0.4 * h / p_wave_speed(pmma()); // half of the limit of the halved cubes
  for (auto *body : {half.get(), whole.get()})
  {
    deform(*body, push);
    for (int step = 0; step < 50; ++step)
    {
      body->advance(step == 0 ? 0.5 * dt : dt, dt);
      body->update_ghosts();
      body->compute_internal_forces({true});
    }
  }
  std::map<std::array<long, 3>, Vector3> there;
  const auto key = [&](const Vector3 &X) -> std::array<long, 3> {
    return {std::lround(4. * X.x() / h), std::lround(4. * X.y() / h), std::lround(4. * X.z() / h)};
  };
  for (int node = 0; node < whole->mesh().n_owned_nodes(); ++node)
    there[key(whole->mesh().reference_position(node))] = at(whole->position(), node);
  double moved = 0.;
  for (int node = 0; node < half->mesh().n_owned_nodes(); ++node)
  {
    const Vector3 X = half->mesh().reference_position(node), x = at(half->position(), node);
    // Displacements of 0.05 h, positions of 3 h, 50 steps.
    EXPECT_LT((x - there.at(key(X))).norm(), 1e-12 * h);
    if (half->mesh().on_mirror_plane(node))
    {
      EXPECT_EQ(x.y(), 0.);
    }
    moved = std::max(moved, (x - push(X)).norm());
  }
  EXPECT_GT(moved, 0.02 * h);
  EXPECT_NEAR(half->total_mass(), 0.5 * whole->total_mass(), 1e-15 * whole->total_mass());
  const auto e = half->energies(dt), f = whole->energies(dt);
  EXPECT_NEAR(2. * e.kinetic, f.kinetic, 1e-11 * f.kinetic);
  EXPECT_NEAR(2. * e.strain, f.strain, 1e-11 * f.strain);
}

TEST(FiniteElementBody, LumpedMassIsPositiveAndAddsUpToTheBody)
{
  const auto body    = make_body(Kind::one_point, refined_box());
  const double exact = pmma_density * 60e-9; // 5 x 4 x 3 mm^3
  EXPECT_NEAR(body->total_mass(), exact, 1e-14 * exact);
  const auto &hanging = body->mesh().hanging_nodes().node;
  // The smallest share is that of a quarter cube's corner, an eighth.
  const double least  = pmma_density * std::pow(0.25e-3, 3) / 8.;
  for (int node = 0; node < body->mesh().n_owned_nodes(); ++node)
    if (std::find(hanging.begin(), hanging.end(), node) != hanging.end())
    {
      EXPECT_EQ(body->mass(node), 0.);
      EXPECT_EQ(body->inverse_mass(node, 0), 0.);
    }
    else
    {
      EXPECT_GT(body->mass(node), 0.999 * least);
      EXPECT_NEAR(body->inverse_mass(node, 2) * body->mass(node), 1., 1e-15);
    }
}

TEST(FiniteElementBody, OwnTensorsOfTheMaterialEqualFullQuadrature)
{
  const auto own  = make_body(Kind::full, refined_box()),
             full = make_body(Kind::full, refined_box());
  give_tensor(*own, own_tensor());
  const auto map = [](const Vector3 &X) -> Vector3 { return X + 0.05e-3 * noise_at(X, 1e-3); };
  deform(*own, map);
  deform(*full, map);
  for (int node = 0; node < full->mesh().n_owned_nodes(); ++node)
    EXPECT_LT((at(own->force(), node) - at(full->force(), node)).norm(),
              1e-13 * largest_force(*full));
  for (std::size_t e = 0; e < full->mesh().elements().size(); ++e)
    EXPECT_LT((own->stress(e) - full->stress(e)).norm(), 1e-13 * full->stress(e).norm() + 1e-3);

  // Taken back, nothing remains of them.
  own->set_stiffness({});
  own->compute_internal_forces({true});
  EXPECT_EQ(own->force(), full->force());
}

TEST(FiniteElementBody, OwnTensorsGiveTheStressOfTheirAverage)
{
  const auto body = make_body(Kind::one_point, {Vector3::Zero(), 1e-3, {2, 1, 1}, false, {}});
  Random random(12);
  ElementStiffness stiffness{1, {}};
  Matrix6 mean = Matrix6::Zero();
  for (auto &tensor : stiffness.tensors)
  {
    const Matrix6 C = random_tensor(random, 1e9);
    tensor          = upper_triangle(C);
    mean += C / 8.;
  }
  body->set_stiffness({stiffness});
  Eigen::Matrix3d F;
  F << 1.01, 0.02, 0.03, -0.01, 0.98, 0.04, 0.05, -0.03, 1.02;
  deform(*body, [&](const Vector3 &X) -> Vector3 { return F * X; });
  const Eigen::Matrix3d E = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
  Eigen::Matrix<double, 6, 1> e;
  e << E(0, 0), E(1, 1), E(2, 2), 2. * E(1, 2), 2. * E(0, 2), 2. * E(0, 1);
  const Eigen::Matrix<double, 6, 1> s = mean * e;
  Eigen::Matrix3d S;
  S << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
  EXPECT_LT((body->stress(1) - S).norm(), 1e-12 * S.norm());
  EXPECT_NEAR(body->strain_energy(1), 0.5e-9 * s.dot(e), 1e-12 * 0.5e-9 * s.dot(e));
  EXPECT_EQ(body->hourglass_energy(1), 0.);
}

TEST(FiniteElementBody, InactiveElementsCarryNothing)
{
  // Without its left half a body is the right half.
  FiniteElementBody::Options options;
  options.active = [](const Vector3 &X) { return X.x() > 2e-3; };
  const HexMesh::Box box{Vector3::Zero(), 1e-3, {4, 2, 2}, false, {}};
  FiniteElementBody part(MPI_COMM_SELF, box, pmma(), options);
  const auto alone =
      make_body(Kind::one_point, {Vector3(2e-3, 0., 0.), 1e-3, {2, 2, 2}, false, {}});
  const auto map = [](const Vector3 &X) -> Vector3 { return X + 0.05e-3 * noise_at(X, 1e-3); };
  deform(part, map);
  deform(*alone, map);
  EXPECT_NEAR(part.total_mass(), alone->total_mass(), 1e-15 * alone->total_mass());
  EXPECT_NEAR(part.energies(0.).strain, alone->energies(0.).strain,
              1e-14 * alone->energies(0.).strain);
  std::map<std::array<long, 3>, int> number;
  const auto key = [](const Vector3 &X) -> std::array<long, 3> {
    return {std::lround(X.x() / 1e-3), std::lround(X.y() / 1e-3), std::lround(X.z() / 1e-3)};
  };
  for (int node = 0; node < alone->mesh().n_owned_nodes(); ++node)
    number[key(alone->mesh().reference_position(node))] = node;
  int n_idle = 0;
  for (int node = 0; node < part.mesh().n_owned_nodes(); ++node)
    if (const auto other = number.find(key(part.mesh().reference_position(node)));
        other != number.end())
    {
      EXPECT_NEAR(part.mass(node), alone->mass(other->second), 1e-20);
      EXPECT_LT((at(part.force(), node) - at(alone->force(), other->second)).norm(),
                1e-13 * largest_force(*alone));
    }
    else
    {
      ++n_idle;
      EXPECT_EQ(part.mass(node), 0.);
      EXPECT_EQ(part.inverse_mass(node, 0), 0.);
      EXPECT_EQ(at(part.force(), node), Vector3(Vector3::Zero()));
    }
  EXPECT_EQ(n_idle, 2 * 3 * 3);
  for (std::size_t e = 0; e < part.mesh().elements().size(); ++e)
    EXPECT_EQ(part.is_active(e), part.mesh().centre(part.mesh().elements()[e]).x() > 2e-3);
}

TEST(FiniteElementBody, FixedComponentsKeepTheirVelocity)
{
  const auto body = make_body(Kind::one_point, {Vector3::Zero(), 1e-3, {2, 1, 1}, false, {}});
  body->fix(0, 0);
  body->fix(0, 2);
  auto velocity = body->velocity();
  set(velocity, 0, Vector3(3., 0., 0.));
  body->set_velocity(velocity);
  deform(*body, [](const Vector3 &X) -> Vector3 { return 1.01 * X; });
  const Vector3 before = at(body->position(), 0), f = at(body->force(), 0);
  EXPECT_GT(f.cwiseAbs().minCoeff(), 0.);
  const double dt = 1e-8;
  body->advance(dt, dt);
  const Vector3 v = at(body->velocity(), 0);
  EXPECT_EQ(v.x(), 3.);
  EXPECT_NEAR(v.y(), dt * f.y() / body->mass(0), 1e-14 * std::abs(v.y()));
  EXPECT_EQ(v.z(), 0.);
  EXPECT_LT((at(body->position(), 0) - before - dt * v).norm(), 1e-18);
  // Masses are lumped anew; what is held stays so.
  body->set_active([](const Vector3 &) { return true; });
  EXPECT_EQ(body->inverse_mass(0, 0), 0.);
  EXPECT_GT(body->inverse_mass(0, 1), 0.);
  EXPECT_EQ(body->inverse_mass(0, 2), 0.);
}

TEST(FiniteElementBody, UnknownInstructionSetIsRefused)
{
  FiniteElementBody::Options options;
  options.instruction_set = "abacus";
  EXPECT_THROW(FiniteElementBody(MPI_COMM_SELF, refined_box(), pmma(), options), InputError);
}
} // namespace
} // namespace ricochet::tests
