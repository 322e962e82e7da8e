// SPDX-License-Identifier: LGPL-2.1-or-later
// What an entry 'Axis N' of a study says: entries, and the values that they take.
#pragma once

#include "ricochet/scene/study_file.h"
#include "section.h"

#include <string>
#include <vector>

namespace ricochet
{
/// Values are separated by '|'; one of them may be a range, "500 m/s to 900 m/s step 50 m/s", which
/// stands for all its members. Throws InputError.
StudyAxis read_axis(const Entry &entry);

/// Whether its values follow from those of another axis: "Section/Entry: = 4 * Axis 1".
bool is_derived(const Entry &entry);

/// Ties the entries of a derived axis to the axis that it follows, whose cases then change them
/// too. rows: the entries of the axes. Throws InputError.
void derive_axis(const Entry &entry, const Entries &rows, std::vector<StudyAxis> &axes);

/// A column of the study's table, and whose value stands in it.
struct AxisColumn
{
  StudyColumn column;
  ParameterEntry entry;
};

/// One per axis, or one per entry where the entries of an axis take values of their own.
std::vector<AxisColumn> columns_of(const std::vector<StudyAxis> &axes);

/// Of the text of an entry, in the unit of its column.
AxisValue value_in(const StudyColumn &column, const std::string &text);

/// Where the value of an override comes from, "study.prm:3 (Axis 1)".
std::string origin_of(const Entry &entry);
} // namespace ricochet
