// SPDX-License-Identifier: LGPL-2.1-or-later
// What a study is for, and which axes that takes.
#pragma once

#include "ricochet/scene/study_file.h"
#include "section.h"

namespace ricochet
{
/// Declares the entry Kind, bound to the study.
const Entry &add_kind(Section &in, StudyParameters &study);

/// Holds the study's axes against its kind. reference: the entry, which in a study of convergence
/// names a value of the first axis. Throws InputError.
void check_kind(const Entry &kind, const Entry &reference, StudyParameters &study);
} // namespace ricochet
