// Weaknesses that tests put into the protocol on purpose, to prove that each attack test fails when its defence is missing.
// Each is a patch in tests/weakened/patches; it asks weakened() where the defence is, in copies of the source files
// (CMakeLists.txt).
#pragma once

namespace skyseal {

/// True if the environment variable SKYSEAL_WEAKNESS, names joined by commas, selects this weakness.
bool weakened(const char *weakness);

/// Tells Valgrind that these bytes, computed from secrets, are public from now on (core/base/declassified.h).
void declassify(const void *bytes, decltype(sizeof 0) count);

} // namespace skyseal
