// A dialect file of the user, read at run time.
#pragma once

#include "core/mavlink/dialect.h"

#include <string>

namespace skyseal::mavlink {

/// The built-in dialect extended by the definitions of the XML file `path`. Includes of standard definitions (common.xml,
/// minimal.xml, …) need not exist as files: they are built in. Otherwise as Dialect::extended().
Result<Dialect, InputError> loadUserDialect(const std::string &path);

} // namespace skyseal::mavlink
