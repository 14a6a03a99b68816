// Formatted text at the end of a string, for the writers of figures.
#pragma once

#include <string>

namespace skyseal::experiment {

/// Appends as printf() formats it, at most 511 bytes.
__attribute__((format(printf, 2, 3))) void put(std::string &out, const char *pattern, ...);

} // namespace skyseal::experiment
