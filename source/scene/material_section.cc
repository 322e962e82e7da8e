// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/elastic_constants.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/materials/bond_laws.h"
#include "ricochet/scene/text_tools.h"
#include "sections.h"

#include <cmath>

namespace ricochet
{
namespace
{
const Words<HistoryPrecision> precisions{{HistoryPrecision::single_precision, "single"},
                                         {HistoryPrecision::double_precision, "double"}};

const Words<bool> broken_bonds{{true, "resist compression"}, {false, "carry nothing"}};

/// The rows that checks speak of, and what the file gives instead of the moduli and the series.
struct MaterialEntries
{
  MaterialParameters &material;
  double youngs_modulus = 0., poissons_ratio = 0.; // [Pa], [-]
  std::vector<double> shares = {}, times = {};     // [-], [s]
  const Entry *bond_model = nullptr, *E = nullptr, *nu = nullptr, *share = nullptr, *time = nullptr;
  const Entry *flow_stress = nullptr, *flow_exponent = nullptr, *flow_slope = nullptr;

  void read_moduli() const;
  void read_relaxation() const;
  void check_flow() const;
  void check_bond_model() const;
};

void MaterialEntries::read_moduli() const
{
  if (!E->is_given())
    return;
  check_poissons_ratio(*nu, poissons_ratio);
  material.bulk_modulus  = bulk_modulus(youngs_modulus, poissons_ratio);
  material.shear_modulus = shear_modulus(youngs_modulus, poissons_ratio);
}

void MaterialEntries::read_relaxation() const
{
  for (const auto &[given, missing] : {std::pair{share, time}, std::pair{time, share}})
    if (given->is_given() && !missing->is_given())
      given->fail("There are no '" + missing->name + "' that belong to them.",
                  "Add them, one for each, or remove the line.");
  if (!share->is_given())
    return;
  if (shares.size() != times.size())
    share->fail("There are " + std::to_string(shares.size()) + " shares, but " +
                    std::to_string(times.size()) + " relaxation times.",
                "Give as many of the one as of the other.");
  for (std::size_t k = 0; k < shares.size(); ++k)
    material.relaxation.push_back({shares[k], times[k]});
  try
  {
    check_series(material.relaxation);
  }
  catch (const InputError &error)
  {
    share->fail(error.what(), "Change shares or times of the section.");
  }
  if (!bond_law(material.bond_model).has_dilatation)
    share->fail("The bond model '" + material.bond_model +
                    "' has no shear modulus of its own that could relax.",
                "Choose 'linear peridynamic solid', or remove the relaxation.");
}

void MaterialEntries::check_flow() const
{
  if (!material.flow.flows())
    return;
  if (!flow_exponent->is_given() || !flow_slope->is_given())
    flow_stress->fail("It needs '" + flow_exponent->name + "' and '" + flow_slope->name + "'.",
                      "Add them, or set it to 0 MPa.");
  if (share->is_given())
    flow_stress->fail("A material that relaxes cannot flow as well.",
                      "Set it to 0 MPa, or remove '" + share->name + "' and '" + time->name + "'.");
  if (!bond_law(material.bond_model).has_dilatation)
    flow_stress->fail("The bond model '" + material.bond_model +
                          "' has no shear modulus of its own that could yield.",
                      "Choose 'linear peridynamic solid', or set it to 0 MPa.");
}

void MaterialEntries::check_bond_model() const
{
  const double ratio = ricochet::poissons_ratio(material.bulk_modulus, material.shear_modulus);
  if (bond_law(material.bond_model).fixes_poisson_ratio && std::abs(ratio - 0.25) > 0.0025)
    bond_model->fail("With this model Poisson's ratio is 0.25, but the moduli give " +
                         number_text(ratio) + ".",
                     "Set the shear modulus to 0.6 times the bulk modulus, or Poisson's ratio to "
                     "0.25, or choose another model.");
}

void add_elastic_entries(Section &in, MaterialEntries &rows)
{
  auto &material  = rows.material;
  rows.bond_model = &in.with_default("Bond model", word(material.bond_model, bond_law_names()),
                                     "linear peridynamic solid", "Force law of the bonds");
  in.required("Density", quantity(material.density, Dimension::density, Limit::positive),
              "1190 kg/m3", "Mass per volume");
  const Entry &bulk = in.optional(
      "Bulk modulus", quantity(material.bulk_modulus, Dimension::stress, Limit::positive),
      "5.9 GPa", "Bulk modulus, together with the shear modulus");
  const Entry &shear = in.optional(
      "Shear modulus", quantity(material.shear_modulus, Dimension::stress, Limit::positive),
      "2.258 GPa", "Shear modulus");
  rows.E = &in.optional(
      "Young's modulus", quantity(rows.youngs_modulus, Dimension::stress, Limit::positive),
      "6.01 GPa", "Instead of these moduli, Young's modulus, together with Poisson's ratio");
  rows.nu =
      &in.optional("Poisson's ratio", quantity(rows.poissons_ratio, Dimension::number, Limit::any),
                   "0.33", "Poisson's ratio between -1 and 0.5");
  in.one_of({{&bulk, &shear}, {rows.E, rows.nu}});
}

void add_fracture_entries(Section &in, MaterialParameters &material)
{
  const Entry &stretch = in.optional(
      "Critical stretch", quantity(material.critical_stretch, Dimension::number, Limit::positive),
      "0.0105", "Relative elongation at which a bond breaks");
  const Entry &energy = in.optional(
      "Energy release rate",
      quantity(material.energy_release, Dimension::surface_energy, Limit::positive), "500 J/m2",
      "Instead of the critical stretch, the energy that a unit of crack area takes");
  in.one_of({{&stretch}, {&energy}});
  in.with_default("Broken bonds", choice(material.cracks_push, broken_bonds), "resist compression",
                  "What a broken bond does until its ends have parted: push as the faces of a "
                  "closed crack do, or nothing");
  in.with_default(
      "Parting extension", quantity(material.parting_extension, Dimension::number, Limit::positive),
      "0.25",
      "Of a broken bond that resists compression, in grid spacings: once it is too long "
      "by so much, its ends have parted for good, and meet as debris");
}

void add_flow_entries(Section &in, MaterialEntries &rows)
{
  auto &flow       = rows.material.flow;
  rows.flow_stress = &in.with_default(
      "Flow stress", quantity(flow.stress, Dimension::stress, Limit::not_negative), "0 MPa",
      "Shear stress at which the material flows without pressure at a shear rate of 1/s; 0: "
      "nothing flows, whatever the two below say. Finite elements stay elastic");
  rows.flow_exponent = &in.optional(
      "Flow rate exponent", quantity(flow.rate_exponent, Dimension::number, Limit::positive),
      "0.06933", "Power of the shear rate, in 1/s, with which the flow stress rises");
  rows.flow_slope =
      &in.optional("Flow pressure coefficient",
                   quantity(flow.pressure_slope, Dimension::number, Limit::not_negative), "0.223",
                   "Shear stress by which the flow stress rises, per pressure");
}

void add_relaxation_entries(Section &in, MaterialEntries &rows)
{
  rows.share = &in.optional(
      "Relaxation shares", quantity_list(rows.shares, Dimension::number, Limit::positive),
      "0.146, 0.541",
      "Shares of the shear modulus, which is the one of a sudden load, that relax; without them "
      "the material is elastic");
  rows.time =
      &in.optional("Relaxation times", quantity_list(rows.times, Dimension::time, Limit::positive),
                   "15.3 s, 95.4 us", "Relaxation times that belong to the shares");
  in.with_default("History precision", choice(rows.material.history_precision, precisions),
                  "single", "Floating-point numbers that hold the strain history of the bonds");
}
} // namespace

void check_poissons_ratio(const Entry &entry, const double nu)
{
  if (!(nu > -1. && nu < 0.5))
    entry.fail("No stable isotropic solid has this Poisson's ratio.",
               "Choose a value between -1 and 0.5, both excluded.");
}

Section material_section(MaterialParameters &material)
{
  Section in(material_prefix + material.name, "A material, used by the plates that name it.");
  const auto rows = std::make_shared<MaterialEntries>(MaterialEntries{material});
  add_elastic_entries(in, *rows);
  add_fracture_entries(in, material);
  add_flow_entries(in, *rows);
  add_relaxation_entries(in, *rows);

  in.check([rows] { rows->read_moduli(); });
  in.check([rows] { rows->read_relaxation(); });
  in.check([rows] { rows->check_flow(); });
  in.check([rows] { rows->check_bond_model(); });
  return in;
}
} // namespace ricochet
