// Formatted text at the end of a string, for the writers of figures.
#pragma once

#include <string>

namespace skyseal::experiment {

/// As printf does it. What exceeds 511 bytes is cut.
__attribute__((format(printf, 2, 3))) void put(std::string &out, const char *pattern, ...);

} // namespace skyseal::experiment
