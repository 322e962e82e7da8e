// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/drivers/check.h"

#include "ricochet/base/units.h"
#include "ricochet/drivers/simulation.h"
#include "ricochet/output/collective.h"
#include "ricochet/scene/scene_reader.h"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>

namespace ricochet
{
namespace
{
using namespace units;

double memory_of_all_ranks(const MPI_Comm communicator)
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  double bytes = 1024. * usage.ru_maxrss;
  MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_DOUBLE, MPI_SUM, communicator);
  return bytes;
}

void print_plates(const Simulation &simulation)
{
  for (std::size_t i = 0; i < simulation.plates().size(); ++i)
  {
    const auto &material = simulation.material(i);
    const auto &lattice  = simulation.plates()[i]->lattice();
    const auto &box      = lattice.box();
    const auto &asked    = simulation.scene().plates[i];
    const double K = material.bulk_modulus, mu = material.shear_modulus,
                 E     = 9. * K * mu / (3. * K + mu);
    const double s_c   = simulation.critical_stretch(i);
    const double width = box.n[1] * box.spacing * (box.mirror_y ? 2. : 1.);
    std::printf("plate %zu        %.4g x %.4g x %.4g mm asked, %.4g x %.4g x %.4g mm modelled%s\n",
                i + 1, asked.length / mm, asked.width / mm, asked.thickness / mm,
                box.n[0] * box.spacing / mm, width / mm, box.n[2] * box.spacing / mm,
                box.mirror_y ? ", half of it computed" : "");
    std::printf("  lattice      %d x %d x %d points, spacing %.4g mm, horizon %.4g mm, %zu bonds "
                "per point\n",
                box.n[0], box.n[1], box.n[2], box.spacing / mm, lattice.stencil().horizon / mm,
                2 * lattice.stencil().offsets.size());
    std::printf("  material     %s: %s, E %.4g GPa, nu %.3f, wave speeds %.0f and %.0f m/s\n",
                material.name.c_str(), material.bond_model.c_str(), E / GPa,
                (3. * K - 2. * mu) / (6. * K + 2. * mu),
                std::sqrt((K + 4. / 3. * mu) / material.density), std::sqrt(mu / material.density));
    std::printf("  fracture     critical stretch %.4g (%s), implied strength E s_c = %.3g MPa, "
                "implied G_c = %.3g J/m2\n",
                s_c, material.critical_stretch > 0. ? "given" : "from G_c", E * s_c / MPa,
                s_c * s_c *
                    fracture_energy_per_squared_stretch(lattice.stencil(),
                                                        bond_law(material.bond_model), K, mu));
  }
}
} // namespace

void check(const MPI_Comm communicator, const ParameterFile &file)
{
  const Scene scene = read_scene(file);
  const Simulation simulation(communicator, scene);
  const double points = simulation.n_points(), bonds = simulation.n_bonds(),
               memory = memory_of_all_ranks(communicator);
  int n_ranks;
  MPI_Comm_size(communicator, &n_ranks);
  if (rank_in(communicator) != 0)
    return;

  const auto info      = simulation.time_step_info();
  const double steps   = std::ceil(scene.time.end_time / simulation.dt());
  const double seconds = steps * info.seconds_per_step;
  const auto &body     = simulation.projectile().body();
  std::printf("scene          %s (%s)\n", scene.title.c_str(), file.path().c_str());
  std::printf("projectile     diameter %.4g mm, length %.4g mm, %.4g g, mean density %.0f kg/m3, "
              "%.4g m/s, %.4g deg, %.4g kJ\n",
              body.shape().diameter / mm, body.shape().length / mm, scene.projectile.mass / g,
              scene.projectile.mass / body.volume(), scene.impact.speed,
              scene.impact.incidence_angle / deg,
              0.5e-3 * scene.projectile.mass * scene.impact.speed * scene.impact.speed);
  if (simulation.projectile().n_elements() > 0)
    std::printf("  deformable   %d %s%s, E %.4g GPa, nu %.3f\n",
                simulation.projectile().n_elements(),
                scene.projectile.model == ProjectileModel::peridynamic ? "points" : "hexahedra",
                scene.symmetric ? " in the half computed" : "",
                scene.projectile.youngs_modulus / GPa, scene.projectile.poissons_ratio);
  print_plates(simulation);
  std::printf("size           %.0f points, %.4g M bonds\n", points, bonds / 1e6);
  std::printf("memory         %.3g GB on %d rank%s\n", memory / 1e9, n_ranks,
              n_ranks == 1 ? "" : "s");
  std::printf("time step      %.4g us (bonds alone would allow %.4g us, contact takes %.0f %% of "
              "the squared frequency)\n",
              simulation.dt() / us, scene.time.safety_factor * 2. / info.frequency / us,
              100. * info.contact_share);
  if (info.projectile_dt < info.plates_dt)
    std::printf("  limited by   the projectile; the plates alone would allow %.4g us: a rigid "
                "projectile takes %.1f times fewer steps\n",
                info.plates_dt / us, info.plates_dt / info.projectile_dt);
  std::printf("steps          at most %.0f to %.4g us%s\n", steps, scene.time.end_time / us,
              scene.time.stop_early ? "; ends when the outcome is decided" : "");
  std::printf("speed          %.0f M directed bonds/s on %d rank%s (%s)\n",
              2e-6 * bonds / info.seconds_per_step, n_ranks, n_ranks == 1 ? "" : "s",
              simulation.plates()[0]->kernel().instruction_set);
  // Debris contact and output: runs of prm/single_plate take 1.5 to 2.5 times their bond forces.
  std::printf("time           %.0f s for the bonds, about %.0f s with debris contact and output\n",
              seconds, 2. * seconds);
}
} // namespace ricochet
