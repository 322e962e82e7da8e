// SPDX-License-Identifier: LGPL-2.1-or-later
// Which ricochet made a result.
#pragma once

namespace ricochet
{
/// The release and, if it was built from a git checkout, the commit: "0.1.0 (git commit abc1234)",
/// with
/// "-dirty" after the commit if the checkout had changes of its own. From a source archive "0.1.0".
/// As of the last build, not of the last configuration.
const char *version();
} // namespace ricochet
