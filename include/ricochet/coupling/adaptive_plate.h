// SPDX-License-Identifier: LGPL-2.1-or-later
// A coupled plate that looks after its peridynamic zone: see adaptive_zone.h.
#pragma once

#include "ricochet/coupling/adaptive_zone.h"

namespace ricochet
{
class AdaptivePlate : public CoupledPlate
{
public:
  /// `growth_ahead`: how far in front of the projectile the zone may grow, along x [m]; all else as
  /// in CoupledPlate and AdaptiveZone. Collective.
  AdaptivePlate(MPI_Comm communicator, std::unique_ptr<Zone> zone,
                std::unique_ptr<PeridynamicBody> points, const CoupledPlateOptions &options,
                const AdaptiveZone::Parameters &parameters, double growth_ahead);

  bool adapt(const Outlook &outlook) override;
  Energies energies(double dt) const override;
  void exchange_state(StateArchive &archive) override;

  const AdaptiveZone &adaptive_zone() const { return adaptive_zone_; } // what became of the zone

private:
  double growth_ahead_;
  AdaptiveZone adaptive_zone_;
};
} // namespace ricochet
