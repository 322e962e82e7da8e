// SPDX-License-Identifier: LGPL-2.1-or-later
// A constant of a law as a row of plain data: how it is called in a parameter file, the member of
// the law's Parameters that takes it, what kind of quantity it is, an example with its unit, and
// what it means. The scene makes an entry of each row; the law knows nothing of parameter files.
#pragma once

#include "ricochet/base/dimension.h"

namespace ricochet
{
template <class Parameters>
struct EntryRow
{
  const char *name;           // laws of one list may share it, then with the same meaning
  double Parameters::*member; // takes the value, in SI
  Dimension dimension;        // what kind of quantity
  Limit limit;                // which values it may take
  const char *example;        // "0.01 s/m"
  const char *meaning;        // half a sentence, "Friction coefficient at rest"
};
} // namespace ricochet
