// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/adaptive_plate.h"

namespace ricochet
{
AdaptivePlate::AdaptivePlate(const MPI_Comm communicator, std::unique_ptr<Zone> zone,
                             std::unique_ptr<PeridynamicBody> points,
                             const CoupledPlateOptions &options,
                             const AdaptiveZone::Parameters &parameters,
                             const double growth_ahead) :
  CoupledPlate(communicator, std::move(zone), std::move(points), options),
  growth_ahead_(growth_ahead), adaptive_zone_(communicator, *this, parameters)
{
}

bool AdaptivePlate::adapt(const Outlook &outlook)
{
  if (!adaptive_zone_.update(outlook.time, outlook.dt, outlook.front + growth_ahead_))
    return false;
  update_ghosts();
  return true;
}

Energies AdaptivePlate::energies(const double dt) const
{
  auto energies       = CoupledPlate::energies(dt);
  energies.conversion = adaptive_zone_.loss();
  return energies;
}

void AdaptivePlate::exchange_state(StateArchive &archive)
{
  CoupledPlate::exchange_state(archive);
  adaptive_zone_.exchange_state(archive);
}
} // namespace ricochet
