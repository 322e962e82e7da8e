// SPDX-License-Identifier: LGPL-2.1-or-later
// What one picture in time consists of, as plain arrays in SI: filled by the simulation, written by
// the output room.
#pragma once

#include "ricochet/base/stress_state.h"
#include "ricochet/base/vector.h"
#include "ricochet/geometry/surface_frame.h"

#include <array>
#include <vector>

namespace ricochet
{
/// Which points and elements a picture consists of.
enum class FrameExtent
{
  everything,
  section // those in the layer next to the plane y = 0
};

/// What is shown of the state of points or elements, one number each.
struct StateFields
{
  std::vector<double> dilatation;     // relative change of the volume [-]
  std::vector<double> pressure;       // [Pa]
  std::vector<double> von_mises;      // [Pa]
  std::vector<double> energy_density; // stored [J/m^3]

  /// Appends one.
  void add(const StressState &state)
  {
    dilatation.push_back(state.dilatation);
    pressure.push_back(ricochet::pressure(state.stress));
    von_mises.push_back(ricochet::von_mises(state.stress));
    energy_density.push_back(state.energy_density);
  }
};

/// The peridynamic points owned by this rank, all or those in the section; all vectors have the
/// same length.
struct PointFrame
{
  std::vector<Vector3> position;     // current [m]
  std::vector<Vector3> displacement; // [m]
  std::vector<Vector3> velocity;     // [m/s]
  std::vector<double> damage;        // broken share of the family, 0 to 1 [-]
  StateFields state;                 // of the same length
  std::vector<int> body;             // number of the plate, from 1
  std::vector<char> in_section;      // 1 if the point lies in the layer next to the plane y = 0
};

/// The finite elements owned by this rank, all or those that the section cuts, without those that
/// are full of points; all vectors but those of the section have the same length.
struct ElementFrame
{
  std::vector<std::array<Vector3, 8>> corners; // current, x + 2 y + 4 z of the cube [m]
  std::vector<Vector3> displacement;           // of the middle [m]
  std::vector<Vector3> velocity;               // of the middle [m/s]
  StateFields state;                           // of the same length
  std::vector<int> body;                       // number of the plate, from 1
  // Places one grid spacing apart in the layer next to the plane y = 0, for the section picture.
  std::vector<Vector3> section_position; // current [m]
  std::vector<int> section_body;         // their plates, from 1
  std::vector<int> section_element;      // their elements, by the number in this frame
};
} // namespace ricochet
