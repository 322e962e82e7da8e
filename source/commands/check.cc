// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check.h"

#include "reference_data.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/base/state_size.h"
#include "ricochet/base/units.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/simulation/interface_report.h"
#include "ricochet/simulation/plate_size.h"
#include "ricochet/simulation/simulation.h"
#include "run_price.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace ricochet
{
namespace
{
using namespace units;

std::string in_time_units(const double time)
{
  return time >= 1. ? with_digits(time, 4) + " s" : with_digits(time / us, 4) + " us";
}

/// The branches, and what is left of the moduli when all that relax have done so.
void print_relaxation(const Simulation &simulation, const std::size_t plate)
{
  const auto &material  = simulation.material(plate);
  const auto &body      = *simulation.plates()[plate];
  const double duration = simulation.scene().time.end_time;
  for (const auto &branch : material.relaxation)
  {
    std::printf("  relaxation   %.3g of the shear modulus (%.4g GPa) in %s: ", branch.share,
                branch.share * material.shear_modulus / GPa, in_time_units(branch.time).c_str());
    if (acts_as_elastic(branch, duration))
      std::printf("acts as elastic, a run of %s is less than 1/%.0f of that\n",
                  in_time_units(duration).c_str(), slowest_relaxation);
    else
      std::printf("%.2g of it left after %s\n", std::exp(-duration / branch.time),
                  in_time_units(duration).c_str());
  }
  if (body.history() == nullptr)
    return;
  // The critical stretch is no stress: the strength that it implies relaxes with Young's modulus,
  // G_c with 3 K + 10 mu.
  const double K  = material.bulk_modulus,
               mu = material.shear_modulus *
                    relaxed_share(body.material().relaxation, std::numeric_limits<double>::max()),
               E = 9. * K * mu / (3. * K + mu);
  std::printf("  relaxed      E %.4g GPa, nu %.3f, wave speeds %.0f and %.0f m/s, strength E s_c = "
              "%.3g MPa\n",
              E / GPa, (3. * K - 2. * mu) / (6. * K + 2. * mu),
              std::sqrt((K + 4. / 3. * mu) / material.density), std::sqrt(mu / material.density),
              E * simulation.critical_stretch(plate) / MPa);
  std::printf("  history      %.0f bytes per point, %s precision\n",
              body.history()->bytes_per_point(),
              body.material().history_precision == HistoryPrecision::single_precision ? "single"
                                                                                      : "double");
}

void print_plates(const Simulation &simulation)
{
  const auto sizes = plate_sizes(simulation.scene());
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const auto &material = simulation.material(i);
    const auto &lattice  = simulation.plates()[i]->lattice();
    const auto &box      = lattice.box();
    const double K = material.bulk_modulus, mu = material.shear_modulus,
                 E   = 9. * K * mu / (3. * K + mu);
    const double s_c = simulation.critical_stretch(i);
    std::printf("plate %zu        %s asked, %s modelled%s\n", i + 1,
                size_text(sizes[i].asked).c_str(), size_text(sizes[i].computed).c_str(),
                box.mirror_y ? ", half of it computed" : "");
    std::printf("  zone         %s\n", simulation.plate(i).zone_reason.c_str());
    if (const auto *const far = simulation.coupled_plate(i))
      std::printf(
          "               peridynamic in %.1f %% of the volume; %.0f elements of %.4g to %.4g "
          "mm, %.0f of them around the zone\n",
          100. * far->zone().n_free_cells() / far->zone().n_cells_in_all(),
          far->multiplicity() * static_cast<double>(far->elements().mesh().n_global_elements() -
                                                    far->zone().n_free_cells()),
          far->zone().points_per_edge() * box.spacing / mm, far->elements().mesh().box().edge / mm,
          far->multiplicity() * static_cast<double>(far->zone().n_slaved_cells()));
    std::printf("  lattice      %d x %d x %d points, spacing %.4g mm, horizon %.4g mm, %zu bonds "
                "per point\n",
                box.n[0], (box.mirror_y ? 2 : 1) * box.n[1], box.n[2], box.spacing / mm,
                lattice.stencil().horizon / mm, 2 * lattice.stencil().offsets.size());
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
    print_relaxation(simulation, i);
  }
}
void print_projectile(const Simulation &simulation, const std::size_t number)
{
  const auto &projectile = simulation.projectile(number);
  const auto &given      = simulation.scene().projectile_at(number);
  const auto &impact     = simulation.scene().impact_at(number);
  const auto &body       = projectile.body();
  std::printf("projectile %-3s diameter %.4g mm, length %.4g mm, %.4g g, mean density %.0f kg/m3, "
              "%.4g m/s, %.4g deg, %.4g kJ\n",
              number == 0 ? "" : std::to_string(number + 1).c_str(), body.shape().diameter / mm,
              body.shape().length / mm, given.mass / g, given.mass / body.volume(), impact.speed,
              impact.incidence_angle / deg, 0.5e-3 * given.mass * impact.speed * impact.speed);
  if (const std::string parts = projectile.parts(); !parts.empty())
    std::printf("  deformable   %s, E %.4g GPa, nu %.3f\n", parts.c_str(),
                given.youngs_modulus / GPa, given.poissons_ratio);
  std::fputs(projectile.description().c_str(), stdout);
}

/// In bytes.
double size_of_state(const MPI_Comm communicator, Simulation &simulation)
{
  StateSize size(communicator);
  simulation.exchange_state(size);
  return size.bytes();
}

/// Sums over all ranks.
struct Cost
{
  double points, bonds; // of whole plates
  RunPrice price;
  double checkpoint; // [bytes]
  int n_ranks;
};

void print_cost(const Simulation &simulation, const Cost &cost)
{
  const auto &time  = simulation.scene().time;
  const auto info   = simulation.time_step_info();
  const char *ranks = cost.n_ranks == 1 ? "rank" : "ranks";
  std::printf("size           %.0f points, %.4g M bonds%s\n", cost.points, cost.bonds / 1e6,
              simulation.scene().symmetric ? ", half of them computed" : "");
  std::printf("memory         %.3g GB on %d %s\n", cost.price.memory / 1e9, cost.n_ranks, ranks);
  const auto &output = simulation.scene().output;
  if (output.checkpoint_interval > 0. || output.checkpoint_wall_interval > 0.)
    std::printf("checkpoint     %.3g MB each, two are kept\n", cost.checkpoint / 1e6);
  std::printf("time step      %.4g us (bonds alone would allow %.4g us, contact takes %.0f %% of "
              "the squared frequency)\n",
              simulation.dt() / us, time.safety_factor * 2. / info.frequency / us,
              100. * info.contact_share);
  if (info.projectile_dt < info.plates_dt)
    std::printf("  limited by   the projectile; the plates alone would allow %.4g us: a rigid "
                "projectile takes %.1f times fewer steps\n",
                info.plates_dt / us, info.plates_dt / info.projectile_dt);
  std::printf("steps          at most %.0f to %.4g us%s\n", cost.price.steps, time.end_time / us,
              time.stop_early ? "; ends when the outcome is decided" : "");
  std::printf("speed          %.0f M directed bonds/s on %d %s (%s)\n",
              2e-6 * simulation.computed_share() * cost.bonds / info.seconds_per_step, cost.n_ranks,
              ranks, simulation.plates()[0]->kernel().instruction_set);
  std::printf("time           %.0f s for the bonds, about %.0f s with debris contact and output\n",
              cost.price.bond_seconds, cost.price.seconds);
}

const char *verdict(const bool good)
{
  return good ? "ok" : "FAILS";
}

void print_interface(const InterfaceReport &r)
{
  std::printf("interface      plate %zu\n", r.plate + 1);
  std::printf("  ghost force  %.2e of strain (K + 4 mu/3) h^2, %d strains; limit %.0e   %s\n",
              r.patch.ghost_force, r.patch.n_strains, InterfaceReport::most_ghost_force,
              verdict(r.ghost_good()));
  std::printf("  strain error %.3f %% after relaxation (%d iterations); limit %.1f %%   %s\n",
              100. * r.patch.strain_error, r.patch.n_iterations,
              100. * InterfaceReport::most_strain_error, verdict(r.strain_good()));
  std::printf("  frequency    %.4g rad/us; step limit %.4g us (predicted %.4g us), step of the "
              "run %.4g us (contact included)   %s\n",
              1e-6 * r.frequency, r.step_limit / us, r.predicted_limit / us, r.time_step / us,
              verdict(r.step_good()));
  std::printf("  share        %.1f %% of the volume is peridynamic and takes %.0f %% of the force "
              "evaluation\n",
              100. * r.share_of_volume, 100. * r.share_of_cost());
}
} // namespace

bool check_scene(const MPI_Comm communicator, const ParameterFile &file,
                 const CheckOptions &options)
{
  const Scene scene = read_scene(file);
  reference_data_of(scene); // whether it can be read
  Simulation simulation(communicator, scene);
  std::vector<InterfaceReport> interfaces;
  if (options.coupling)
    interfaces = interface_reports(communicator, simulation);
  const bool good = std::all_of(interfaces.begin(), interfaces.end(),
                                [](const InterfaceReport &report) { return report.good(); });
  const Cost cost{simulation.n_points(), simulation.n_bonds(), price_of(communicator, simulation),
                  size_of_state(communicator, simulation), size_of(communicator)};
  if (rank_in(communicator) != 0)
    return good;

  std::printf("scene          %s (%s)\n", scene.title.c_str(), file.path().c_str());
  for (std::size_t i = 0; i < simulation.n_projectiles(); ++i)
    print_projectile(simulation, i);
  print_plates(simulation);
  print_cost(simulation, cost);
  if (options.coupling && interfaces.empty())
    std::printf("interface      none: no plate has both points and elements\n");
  for (const auto &report : interfaces)
    print_interface(report);
  return good;
}
} // namespace ricochet
