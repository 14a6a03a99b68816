// 32 bytes as text with a check, so that damage is detected.
#pragma once

#include "core/base/secret_bytes_fwd.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace skyseal::keys {

inline constexpr std::size_t kCheckedBase64Length = 48;

/// URL-safe base64 of the bytes and of the first four of BLAKE2b-256(label | bytes). Encoded and decoded in constant
/// time, since the bytes may be secret; the caller then wipes the text.
std::string toCheckedBase64(std::span<const std::uint8_t, 32> bytes, std::string_view label);

/// nullopt for a wrong length, invalid characters, or a wrong check.
std::optional<Key32> fromCheckedBase64(std::string_view text, std::string_view label);

} // namespace skyseal::keys
