// SPDX-License-Identifier: LGPL-2.1-or-later
// The kinds of energy that bodies tell of. A new one is a member and a row here, and the body that
// computes it: sums, balance, history and their documentation follow from the rows.
#pragma once

namespace ricochet
{
/// What a body holds and what it has given away or received so far [J].
struct Energies
{
  double kinetic    = 0.; // see Body::energies()
  double strain     = 0.; // in bonds and elements
  double hourglass  = 0.; // in the hourglass modes of one-point elements
  double conversion = 0.; // lost so far where elements became points
  double fracture   = 0.; // released by broken bonds so far
  double viscous    = 0.; // turned into heat by relaxation so far
  double plastic    = 0.; // turned into heat by plastic flow so far
  double absorbed   = 0.; // by edges that do not reflect, so far
  double drive      = 0.; // received so far from what prescribes a motion

  /// Entry by entry.
  Energies &operator+=(const Energies &other);
  /// What it holds now: the sum that the scheme conserves while nothing breaks or relaxes.
  double held() const;
};
/// Entry by entry.
Energies operator*(double factor, const Energies &energies);

/// How a balance counts an energy.
enum class EnergyAccount
{
  held,    // now
  given,   // away so far
  received // from outside so far
};

/// One kind of energy, of a struct that has it as a member.
template <class Struct>
struct EnergyRow
{
  double Struct::*value; // the member
  EnergyAccount account; // how it counts
  const char *name;      // of its column in the history
  const char *meaning;   // half a sentence, for the user
};

/// All of Energies, of the plates together.
inline constexpr EnergyRow<Energies> energy_rows[] = {
    {&Energies::kinetic, EnergyAccount::held, "energy kinetic", "of the plates"},
    {&Energies::strain, EnergyAccount::held, "energy strain",
     "stored in the plates' bonds and elements"},
    {&Energies::hourglass, EnergyAccount::held, "energy hourglass",
     "stored in the hourglass modes of one-point elements"},
    {&Energies::conversion, EnergyAccount::given, "loss conversion",
     "lost where elements became points"},
    {&Energies::fracture, EnergyAccount::given, "energy fracture", "released by broken bonds"},
    {&Energies::viscous, EnergyAccount::given, "energy viscous", "turned into heat by relaxation"},
    {&Energies::plastic, EnergyAccount::given, "energy plastic",
     "turned into heat by plastic flow"},
    {&Energies::absorbed, EnergyAccount::given, "energy absorbed",
     "has left through edges that do not reflect"},
    {&Energies::drive, EnergyAccount::received, "work drive",
     "received from what keeps a projectile of prescribed velocity going"}};
} // namespace ricochet
