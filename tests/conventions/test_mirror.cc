// SPDX-License-Identifier: LGPL-2.1-or-later
// Tests mirror the rooms: source/<room>/<unit>.cc has tests/<room>/test_<unit>.cc, or stands here
// with the test that exercises it.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <string>

namespace
{
namespace fs = std::filesystem;

/// Units without a test of their name, and the test in which they would fail.
const std::map<std::string, std::string> covered_elsewhere = {
    {"bodies/nearest_rigid_motion", "finite_elements/test_hexahedral_body"},
    {"commands/bench/history", "commands/test_command_line"}, // parsed; its figures are for reading
    {"commands/bench/search_points", "commands/bench/test_search"},
    {"commands/checkpoints", "commands/test_resume"},
    {"commands/describe_run", "commands/test_run"},
    {"commands/ensemble", "commands/test_study"},
    {"commands/grid_levels", "commands/test_convergence"},
    {"commands/history_rows", "commands/test_reference_data"},
    {"commands/main", "commands/test_command_line"},
    {"commands/reference_comparison", "commands/test_reference_data"},
    {"commands/result_folder", "commands/test_run"},
    {"commands/run_price", "commands/test_check"},
    {"commands/scene_run", "commands/test_run"},
    {"commands/several_processes", "commands/test_command_line"},
    {"commands/study_case", "commands/test_study"},
    {"commands/study_jobs", "commands/test_study"}, // and commands/study_jobs.sh
    {"commands/study_price", "commands/test_study"},
    {"commands/study_runs", "commands/test_study"},
    {"commands/study_table", "commands/test_study"},
    {"commands/warning", "commands/test_run_warnings"},
    // All searches find exactly what the double loop finds.
    {"contact/body_skin", "contact/test_contact_search"},
    {"contact/broken_bond_pairs", "contact/test_contact_search"},
    {"contact/candidate_search", "contact/test_contact_search"},
    {"contact/contact_ghosts", "contact/test_contact_search"},
    {"contact/contact_numbering", "contact/test_contact_search"},
    {"contact/contact_pairs", "contact/test_contact_search"},
    {"contact/contact_skin", "contact/test_contact_search"},
    {"contact/friction_work", "contact/test_short_range_contact"},
    {"contact/hybrid_candidate_search", "contact/test_contact_search"},
    {"contact/local_candidate_search", "contact/test_contact_search"},
    {"contact/surface_tangents", "contact/test_surface_contact"},
    {"coupling/adaptive_plate", "coupling/test_rank_invariance"},
    {"coupling/calibrated_elements", "coupling/test_calibration"},
    {"coupling/coupled_plate", "coupling/test_conversion"},
    {"coupling/coupled_plate_conversion", "coupling/test_conversion"},
    {"coupling/coupled_plate_interface", "coupling/test_conversion"},
    {"coupling/coupled_plate_stress", "coupling/test_plate_stress"},
    {"coupling/coupled_plate_state", "simulation/test_checkpoint"},
    {"coupling/coupled_plate_vibration", "dynamics/test_frequency_bound"},
    {"coupling/coupled_projectile_motion", "coupling/test_coupled_projectile_body"},
    {"coupling/nodal_means", "coupling/test_plate_stress"},
    {"coupling/plate_elements", "simulation/test_plate_zone"},
    {"coupling/stiffness_least_squares", "coupling/test_calibration"},
    {"finite_elements/element_groups", "finite_elements/test_finite_element_body"},
    {"finite_elements/element_state", "simulation/test_checkpoint"},
    {"finite_elements/finite_element_vibration", "dynamics/test_frequency_bound"},
    {"finite_elements/free_components", "finite_elements/test_free_vibration"},
    {"finite_elements/hex_cells", "finite_elements/test_hex_mesh"},
    {"finite_elements/hexahedral_vibration", "dynamics/test_frequency_bound"},
    {"finite_elements/hexahedron", "finite_elements/test_hexahedral_body"},
    {"finite_elements/lumped_mass", "finite_elements/test_finite_element_body"},
    {"finite_elements/mass_properties", "finite_elements/test_modal_body"},
    {"finite_elements/node_numbers", "finite_elements/test_hex_mesh"},
    {"finite_elements/shared_sums", "finite_elements/test_rank_agreement"},
    {"geometry/faceted_surface", "geometry/test_hex_solid"},
    {"geometry/revolved_hexes", "geometry/test_hex_solid"},
    {"output/checkpoint_reader", "output/test_checkpoint_file"},
    {"output/checkpoint_writer", "output/test_checkpoint_file"},
    {"output/folder_lock", "output/test_result_directory"},
    {"output/section_writer", "output/test_field_writer"},
    {"peridynamics/peridynamic_body_changes", "peridynamics/test_redistribution"},
    {"peridynamics/peridynamic_vibration", "dynamics/test_largest_frequency"},
    {"projectiles/accepted_shape", "projectiles/test_mesh_fit"},
    // All three models of the projectile, in whole impacts.
    {"projectiles/deformable_projectile", "projectiles/test_finite_element_projectile"},
    {"projectiles/peridynamic_projectile", "projectiles/test_finite_element_projectile"},
    {"projectiles/projectile_contact", "simulation/test_contact_record_in_runs"},
    {"projectiles/skin", "projectiles/test_finite_element_projectile"},
    {"scene/bindings", "scene/test_section"},
    {"scene/contact_section", "scene/test_scene_reader"},
    {"scene/entry_patterns", "scene/test_quantity"},
    {"scene/error_list", "scene/test_bad_input"},
    {"scene/file_reader", "scene/test_parameter_file"},
    {"scene/impact_section", "scene/test_scene_reader"},
    {"scene/law_entries", "scene/test_material_entries"},
    {"scene/material_section", "scene/test_material_entries"},
    {"scene/output_section", "scene/test_scene_reader"},
    {"scene/parameter_writer", "scene/test_parameter_template"},
    {"scene/plate_section", "scene/test_scene_reader"},
    {"scene/projectile_section", "scene/test_projectile_entries"},
    {"scene/schema", "scene/test_parameter_template"},
    {"scene/section_checks", "scene/test_section"},
    {"scene/stability_reader", "scene/test_stability_section"},
    {"scene/study_axis", "scene/test_study_file"},
    {"scene/study_section", "scene/test_study_file"},
    {"scene/study_kind", "scene/test_study_file"},
    {"scene/study_limit", "scene/test_study_file"},
    {"scene/study_plan", "scene/test_study_file"},
    {"simulation/zone_cells", "simulation/test_plate_zone"},
    {"scene/time_section", "scene/test_scene_reader"},
    {"search/brute_force", "search/test_pair_search"},
    {"search/cell_grid", "search/test_pair_search"},
    {"search/kd_tree", "search/test_pair_search"},
    {"search/linked_cells", "search/test_pair_search"},
    {"search/near_points", "search/test_hybrid_search"},
    {"search/pair_loops", "search/test_pair_search"},
    {"simulation/simulation_time_step", "simulation/test_time_step"},
    {"simulation/zone_summary", "simulation/test_run_summary"},
};

/// Compiled once per instruction set, each tested through its table of functions; and declarations
/// of the command line, which commands/test_command_line parses.
bool is_variant(const std::string &unit)
{
  return std::regex_search(unit, std::regex("_(baseline|avx2|avx512)$|^commands/cli/"));
}

fs::path test_of(const std::string &unit)
{
  const fs::path path(unit);
  return path.parent_path() / ("test_" + path.filename().string());
}

TEST(Mirror, EveryUnitHasATestOrStandsInTheList)
{
  const fs::path source = fs::path(RICOCHET_SOURCE_DIR) / "source";
  const fs::path tests  = fs::path(RICOCHET_SOURCE_DIR) / "tests";
  int n_units           = 0;
  for (const auto &entry : fs::recursive_directory_iterator(source))
  {
    if (entry.path().extension() != ".cc")
      continue;
    const std::string unit =
        fs::relative(entry.path(), source).replace_extension("").generic_string();
    if (is_variant(unit))
      continue;
    ++n_units;
    const bool has_test = fs::exists(tests / (test_of(unit).string() + ".cc"));
    EXPECT_NE(has_test, covered_elsewhere.count(unit) > 0)
        << unit << (has_test ? " has a test now: take it off the list" : " has no test");
  }
  EXPECT_GT(n_units, 100) << "the tree was not found";
}

TEST(Mirror, TheListNamesWhatThereIs)
{
  const fs::path root(RICOCHET_SOURCE_DIR);
  for (const auto &[unit, test] : covered_elsewhere)
  {
    EXPECT_TRUE(fs::exists(root / "source" / (unit + ".cc"))) << unit;
    EXPECT_TRUE(fs::exists(root / "tests" / (test + ".cc"))) << test;
  }
}
} // namespace
