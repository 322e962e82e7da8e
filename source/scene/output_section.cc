// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sections.h"

namespace ricochet
{
Section output_section(OutputParameters &output, const std::string &stem)
{
  Section in("Output", "What is written, and where.");
  in.named_after_file("Directory",
                      text(output.directory, "a folder, relative to where the program is started"),
                      "output/" + stem, "output/oblique_impact",
                      "Where the results go, by default output/ and the file's name");
  in.with_default("Frame interval",
                  quantity(output.frame_interval, Dimension::time, Limit::not_negative), "20 us",
                  "Time between two frames of all points; 0 us for none");
  in.with_default("History interval",
                  quantity(output.history_interval, Dimension::time, Limit::positive), "2 us",
                  "Time between two rows of the history");
  in.with_default("Checkpoint interval",
                  quantity(output.checkpoint_interval, Dimension::time, Limit::not_negative),
                  "0 us",
                  "Simulated time between two checkpoints, from which --resume goes on; 0 us for "
                  "none");
  in.with_default("Checkpoint wall-clock interval",
                  quantity(output.checkpoint_wall_interval, Dimension::time, Limit::not_negative),
                  "10 min", "The same on the clock on the wall; 0 s for none");
  in.with_default("ParaView files", flag(output.vtu), "true",
                  "Whether the frames are written for ParaView");
  in.with_default("Pictures", flag(output.pictures), "true",
                  "Whether pictures are drawn at the end");
  in.with_default("Report", flag(output.report), "true",
                  "Whether report.html is written at the end: verdict, pictures, charts, tables, "
                  "parameters in one file");
  const Entry &times = in.optional(
      "Picture times", quantity_list(output.picture_times, Dimension::time, Limit::not_negative),
      "45 us, 94 us, 142 us",
      "Times of the section's picture, ascending; the summary says where the projectile is then. "
      "By default six from the first to the last frame");

  const Entry &data = in.optional(
      "Reference data", text(output.reference_data, "a CSV file, relative to this file"),
      "experiment.csv",
      "Somebody else's columns of the history over time, to compare the run with: errors in the "
      "summary, marks in the pictures");

  in.check(
      [&output, &times, &data]
      {
        output.reference_data = path_of_file(data, output.reference_data);
        const auto &time      = output.picture_times;
        for (std::size_t i = 1; i < time.size(); ++i)
          if (time[i] <= time[i - 1])
            times.fail("Time " + std::to_string(i + 1) + " does not come after time " +
                           std::to_string(i) + ".",
                       "Write the times in ascending order, each once.");
      });
  return in;
}
} // namespace ricochet
