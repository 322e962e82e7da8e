// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_fit.h"

#include "accepted_shape.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/number_text.h"
#include "ricochet/geometry/hex_pieces.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace ricochet
{
namespace
{
// Nodes as far from each other, or from the symmetry plane, are meant to coincide: files have six
// significant digits or more.
constexpr double coincidence = 1e-6; // of the diameter

[[noreturn]] void refuse(const std::string &what, const std::string &remedy)
{
  throw InputError("Projectile/Mesh: The mesh of the projectile " + what + ".\n  " + remedy);
}

std::string in_mm(const double x)
{
  return with_digits(1e3 * x, 4) + " mm";
}

void require_one_piece(const HexSolid &mesh, const double diameter)
{
  const auto sizes       = piece_sizes(mesh);
  const int n_coincident = n_coincident_nodes(mesh, coincidence * diameter);
  const std::string
      both = std::to_string(n_coincident) + " nodes lie where another one lies",
      join = "Join the volumes before they are meshed ('Coherence;' in gmsh), or remove what "
             "is not the projectile.";
  if (sizes.size() > 1)
    refuse("falls into " + std::to_string(sizes.size()) +
               " pieces that share no face; the largest has " + std::to_string(sizes[0]) + " of " +
               std::to_string(mesh.cells.size()) + " hexahedra" +
               (n_coincident > 0 ? ", and " + both : ""),
           join);
  if (n_coincident > 0)
    refuse("has gaps: " + both + " and are not joined", join);
}

/// A mesh beside the body that it should be.
class Comparison
{
public:
  Comparison(const HexSolid &mesh, const BodyOfRevolution &body);

  void require_size() const;
  void require_part(bool symmetric) const;
  void require_axis() const;
  void require_surface() const;
  void require_volume() const;

  double base() const { return low_.x(); } // axial, in the mesh [m]
  bool is_half() const { return is_half_[1]; }

private:
  struct Misfit
  {
    double distance = 0.; // by which the limit is missed, 0 if none is [m]
    double x = 0., radius = 0.;
  };
  /// The place where the surface misses its limits by most, also of the mesh turned round.
  Misfit worst_misfit(bool turned) const;
  bool lies_on_cut(const SurfaceQuad &quad) const;

  const HexSolid &mesh_;
  const BodyOfRevolution &body_;
  AcceptedShape accepted_;
  double length_, diameter_;         // of the body [m]
  Vector3 low_, high_, size_;        // box around the mesh [m]
  std::array<bool, 3> is_half_ = {}; // across this axis
  std::vector<Vector3> surface_;     // corners and centres of its faces but for the cut [m]
};

Comparison::Comparison(const HexSolid &mesh, const BodyOfRevolution &body) :
  mesh_(mesh), body_(body), accepted_(body), length_(body.shape().length),
  diameter_(body.shape().diameter), low_(mesh.nodes[0]), high_(low_)
{
  for (const auto &x : mesh.nodes)
  {
    low_  = low_.cwiseMin(x);
    high_ = high_.cwiseMax(x);
  }
  size_ = high_ - low_;
  for (const int d : {1, 2})
    is_half_[d] = std::abs(size_[d] - diameter_ / 2.) <= AcceptedShape::most_error * diameter_ / 2.;
  for (const auto &quad : surface_of(mesh))
  {
    if (lies_on_cut(quad))
      continue;
    Vector3 centre = Vector3::Zero();
    for (const int node : quad)
    {
      surface_.push_back(mesh.nodes[node]);
      centre += 0.25 * mesh.nodes[node];
    }
    surface_.push_back(centre);
  }
}

void Comparison::require_size() const
{
  const double play  = accepted_.length_error();
  const auto is_wide = [this](const double width)
  { return std::abs(width - diameter_) <= AcceptedShape::most_error * diameter_; };
  const auto is_long = [&](const double length) { return std::abs(length - length_) <= play; };
  if (is_long(size_.x()) && (is_half_[1] || is_wide(size_.y())) &&
      (is_half_[2] || is_wide(size_.z())))
    return;
  std::string axis;
  for (const int d : {1, 2})
    if (is_long(size_[d]) && is_wide(size_.x()) && is_wide(size_[3 - d]))
      axis = std::string(" Here it seems to be ") + (d == 1 ? "y." : "z.");
  refuse("does not fit its shape: it is " + with_digits(1e3 * size_.x(), 4) + " x " +
             with_digits(1e3 * size_.y(), 4) + " x " + in_mm(size_.z()) +
             " (x, y, z); the shape is " + in_mm(length_) + " long, of which " + in_mm(play) +
             " may be missed, with a diameter of " + in_mm(diameter_) + ", of which " +
             with_digits(100. * AcceptedShape::most_error, 2) + " % may",
         "The axis of the mesh is the x axis, the tip at its upper end." + axis +
             " Set 'Projectile/Mesh unit', or correct the lengths.");
}

void Comparison::require_part(const bool symmetric) const
{
  const bool is_upper = is_half_[1] && std::abs(low_.y()) < std::abs(high_.y());
  if (is_half_[2] || (is_half_[1] && !is_upper))
  {
    std::string part = is_half_[1] ? (is_upper ? "y >= 0" : "y <= 0") : "";
    if (is_half_[2])
      part += (part.empty() ? "" : " and ") +
              std::string(std::abs(low_.z()) < std::abs(high_.z()) ? "z >= 0" : "z <= 0");
    refuse("holds only its part " + part,
           "Mesh the whole projectile; in a symmetric scene its half y >= 0 will do.");
  }
  if (is_upper && !symmetric)
    refuse("holds only its half y >= 0, and the scene is computed whole",
           "Set 'Symmetric = true', or mesh the whole projectile.");
  if (is_upper && std::abs(low_.y()) > coincidence * diameter_)
    refuse("is a half that is cut at y = " + in_mm(low_.y()),
           "Move it: the symmetry plane of the scene is y = 0.");
}

void Comparison::require_axis() const
{
  Vector3 centre = centroid(mesh_);
  if (is_half())
    centre.y() = 0.; // the cut is on the plane
  if (std::hypot(centre.y(), centre.z()) > AcceptedShape::most_error * diameter_ / 2.)
    refuse("has its axis at y = " + in_mm(centre.y()) + ", z = " + in_mm(centre.z()),
           "Move the mesh: its axis is the x axis, y = z = 0.");
}

bool Comparison::lies_on_cut(const SurfaceQuad &quad) const
{
  return is_half() && std::all_of(quad.begin(), quad.end(),
                                  [this](const int node)
                                  { return mesh_.nodes[node].y() <= coincidence * diameter_; });
}

Comparison::Misfit Comparison::worst_misfit(const bool turned) const
{
  Misfit worst;
  for (const auto &place : surface_)
  {
    const double x           = turned ? high_.x() - place.x() : place.x() - low_.x();
    const double radius      = std::hypot(place.y(), place.z());
    const auto [least, most] = accepted_.radii(x);
    const double distance    = std::max(least - radius, radius - most);
    if (distance > std::max(worst.distance, coincidence * diameter_))
      worst = {distance, x, radius};
  }
  return worst;
}

void Comparison::require_surface() const
{
  const Misfit worst = worst_misfit(/*turned=*/false);
  if (worst.distance == 0.)
    return;
  if (worst_misfit(/*turned=*/true).distance == 0.)
    refuse("has its tip at the lower end of x, and would fly base first",
           "Turn it round: the tip points to larger x.");
  const auto [least, most] = accepted_.radii(worst.x);
  refuse("does not fit its shape: " + in_mm(worst.x) + " from the base its surface lies " +
             in_mm(worst.radius) + " from the axis, where " + in_mm(least) + " to " + in_mm(most) +
             " are accepted",
         worst.radius < least
             ? "Correct 'Projectile/Nose shape' and its lengths, or the mesh: no cavities, no "
               "hexahedra that are not joined, two layers or more in the nose, eight edges or more "
               "around the axis."
             : "Correct 'Projectile/Nose shape' and its lengths, or the mesh.");
}

void Comparison::require_volume() const
{
  const double part = is_half() ? 0.5 : 1., own = volume(mesh_);
  auto [least, most] = accepted_.volumes();
  least *= part;
  most *= part;
  if (own >= least && own <= most)
    return;
  const auto in_mm3 = [](const double v) { return with_digits(1e9 * v, 4) + " mm3"; };
  refuse("does not fit its shape: its volume is " + in_mm3(own) + ", where " + in_mm3(least) +
             " to " + in_mm3(most) + " are accepted and the " + (is_half() ? "half" : "whole") +
             " shape has " + in_mm3(part * body_.volume()),
         own < least ? "Fill what is hollow, or mesh it finer."
                     : "Remove hexahedra that lie in the place of others.");
}
} // namespace

HexSolid fitted(HexSolid mesh, const BodyOfRevolution &body, const bool symmetric)
{
  const double diameter = body.shape().diameter;
  require_one_piece(mesh, diameter);
  const Comparison comparison(mesh, body);
  comparison.require_size();
  comparison.require_part(symmetric);
  comparison.require_axis();
  comparison.require_surface();
  comparison.require_volume();
  const double shift = body.base_position() - comparison.base();
  if (comparison.is_half())
    mesh = upper_half(mesh, coincidence * diameter);
  for (auto &x : mesh.nodes)
    x.x() += shift;
  return mesh;
}
} // namespace ricochet
