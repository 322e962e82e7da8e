// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/damage_map.h"

#include "hdf5_file.h"
#include "ricochet/output/collective.h"

#include <string>

namespace ricochet
{
void write_damage_maps(const MPI_Comm comm, const std::filesystem::path &directory,
                       const std::vector<DamageMap> &maps)
{
  on_first_rank(comm,
                [&]
                {
                  Hdf5File file;
                  for (const auto &map : maps)
                  {
                    const std::string plate = "plate_" + std::to_string(map.plate);
                    const std::vector<double> grid{map.spacing, map.corner[0], map.corner[1],
                                                   map.mirrored ? 1. : 0.};
                    file.add(plate + "_grid", grid, 1, "m");
                    file.add(plate + "_front", map.front, map.n_y, "-");
                    file.add(plate + "_rear", map.rear, map.n_y, "-");
                    file.add(plate + "_mean", map.mean, map.n_y, "-");
                  }
                  file.save(directory / "damage.h5");
                });
}
} // namespace ricochet
