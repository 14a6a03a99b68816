// Reads dialect definitions in MAVLink's XML (https://mavlink.io/en/guide/xml_schema.html), with their includes. Used by
// the generator at build time and for dialects of the user at run time; the files are not trusted.
#pragma once

#include "core/base/result.h"
#include "core/mavlink/dialect_definition.h"

#include <span>
#include <string>
#include <string_view>

namespace skyseal::mavlink {

/// The definitions of `path` and of the files that it includes (relative to it, each once), laid out. Includes named in `known`
/// may be missing. Limits: 16 MiB a file, 64 files, 8 levels of includes, 8192 messages, enums, and entries of an enum.
Result<DialectDefinition, InputError> readDialectXml(const std::string &path, std::span<const std::string_view> known = {});

} // namespace skyseal::mavlink
