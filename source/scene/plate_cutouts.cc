// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plate_cutouts.h"

#include "sections.h"

namespace ricochet
{
namespace
{
struct Range
{
  double from, to;

  bool is_empty() const { return from >= to; }
  bool misses(const double low, const double high) const { return to <= low || from >= high; }
};

void check_extents(const Entry &entry, const PlateParameters &plate, const std::vector<Range> &own,
                   const std::array<double, 4> &column, const Range &depth)
{
  const double half       = plate.width / 2.;
  const std::string where = "x lies between 0 mm and " + in_mm(plate.length) + ", y between -" +
                            in_mm(half) + " and " + in_mm(half) +
                            ", and depth, below the plate's own upper face, between 0 mm and " +
                            in_mm(plate.thickness) + ", from below to.";
  for (const auto &range : own)
    if (range.is_empty())
      entry.fail("It is empty: " + in_mm(range.from) + " is not below " + in_mm(range.to) + ".",
                 where);
  // The one direction in which a crack has no extent must lie inside, too.
  if (Range{column[0], column[1]}.misses(0., plate.length) ||
      Range{column[2], column[3]}.misses(-half, half) || depth.misses(0., plate.thickness))
    entry.fail("It misses the plate.", where);
}

void check_extents(const Entry &entry, const PlateParameters &plate, const Cutouts::Hole &hole)
{
  if (hole.diameter <= 0.)
    entry.fail("The diameter of a hole is above 0.", "The entry is 'x, y, diameter'.");
  check_extents(entry, plate, {}, column_of(hole), {0., plate.thickness});
}

void check_extents(const Entry &entry, const PlateParameters &plate, const Cutouts::Notch &notch)
{
  check_extents(
      entry, plate,
      {{notch.x_from, notch.x_to}, {notch.y_from, notch.y_to}, {notch.depth_from, notch.depth_to}},
      column_of(notch), {notch.depth_from, notch.depth_to});
}

void check_extents(const Entry &entry, const PlateParameters &plate, const Cutouts::Crack &crack)
{
  check_extents(entry, plate, {{crack.from, crack.to}, {crack.depth_from, crack.depth_to}},
                column_of(crack), {crack.depth_from, crack.depth_to});
}

template <class Rows, class Cutout>
void take(const Rows &rows, const PlateParameters &plate, std::vector<Cutout> &cutouts)
{
  for (const auto &row : rows)
    if (row.entry->is_given())
    {
      check_extents(*row.entry, plate, row.value);
      cutouts.push_back(row.value);
    }
}

template <class Rows>
void check_rows(const Rows &rows, const Scene &scene)
{
  for (const auto &row : rows)
  {
    if (!row.entry->is_given())
      continue;
    if (scene.symmetric && !is_symmetric(row.value))
      row.entry->fail("It is not its own mirror image, and only the half y > 0 is computed.",
                      "Let it lie evenly about y = 0 mm, or compute the whole plate with 'set "
                      "Symmetric = false'.");
    if (scene.zone.kind == ZoneKind::none)
      row.entry->fail("Finite elements alone have no holes, notches or cracks: it must lie among "
                      "peridynamic points.",
                      "Choose 'set Zone = everything', 'automatic' or 'boxes' in the section "
                      "'Coupling'; points are then put around it.");
  }
}
} // namespace

void CutoutRows::add_to(Section &in)
{
  const char *second[]  = {"", " 2"};
  const char *meaning[] = {"A hole, a cylinder through the plate", "Another hole"};
  for (int i = 0; i < 2; ++i)
  {
    auto &[hole, entry] = holes_[i];
    entry               = &in.optional(std::string("Hole") + second[i],
                                       quantities({&hole.x, &hole.y, &hole.diameter}, {"x", "y", "diameter"},
                                                  Dimension::length, Limit::any),
                                       "60 mm, 0 mm, 12 mm", meaning[i]);
  }
  const char *box[] = {"A box without material; depth counts downwards from the plate's own upper "
                       "face",
                       "Another such box"};
  for (int i = 0; i < 2; ++i)
  {
    auto &[n, entry] = notches_[i];
    entry            = &in.optional(
                   std::string("Notch") + second[i],
                   quantities({&n.x_from, &n.x_to, &n.y_from, &n.y_to, &n.depth_from, &n.depth_to},
                              {"x from", "x to", "y from", "y to", "depth from", "depth to"},
                              Dimension::length, Limit::any),
                   "58 mm, 62 mm, -20 mm, 20 mm, 0 mm, 5 mm", box[i]);
  }
  const char *first_crack =
      "A crack that is there from the start: a rectangle in the plane of that x. The bonds that "
      "cross it are broken; depth as of a notch";
  const char *plane[] = {first_crack, "Another such crack", "The same in the plane of that y",
                         "Another such crack"};
  for (int i = 0; i < 4; ++i)
  {
    const bool along = i >= 2;
    auto &[c, entry] = cracks_[i];
    c.normal         = along ? 1 : 0;
    const char *x    = along ? "y" : "x";
    const char *y[2] = {along ? "x from" : "y from", along ? "x to" : "y to"};
    entry            = &in.optional(
                   std::string(along ? "Crack along" : "Crack across") + second[i % 2],
                   quantities({&c.at, &c.from, &c.to, &c.depth_from, &c.depth_to},
                              {x, y[0], y[1], "depth from", "depth to"}, Dimension::length, Limit::any),
        along ? "0 mm, 80 mm, 120 mm, 0 mm, 10 mm" : "60 mm, -20 mm, 20 mm, 0 mm, 10 mm", plane[i]);
  }
}

void CutoutRows::read()
{
  take(holes_, plate_, plate_.cutouts.holes);
  take(notches_, plate_, plate_.cutouts.notches);
  take(cracks_, plate_, plate_.cutouts.cracks);
}

void CutoutRows::check_with_others() const
{
  check_rows(holes_, scene_);
  check_rows(notches_, scene_);
  check_rows(cracks_, scene_);
}
} // namespace ricochet
