// A dialect that a user brings along, read while the program runs.
#pragma once

#include "core/mavlink/dialect.h"

#include <string>

namespace skyseal::mavlink {

/// The built-in dialect and what the XML file `path` defines beside it. Includes of standard definitions (common.xml,
/// minimal.xml, …) need not lie beside the file: they are built in. Otherwise the rules of Dialect::extended().
Result<Dialect, InputError> loadUserDialect(const std::string &path);

} // namespace skyseal::mavlink
