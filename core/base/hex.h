// Hexadecimal text of bytes, for public values only (fingerprints, frames, test vectors).
#pragma once

#include "core/base/bytes.h"

#include <optional>
#include <string>

namespace skyseal {

std::string toHex(ByteView bytes);

/// Bytes of an even number of hex digits, upper or lower case; nullopt for anything else.
std::optional<Bytes> fromHex(std::string_view text);

} // namespace skyseal
