// Thirty-two bytes as one word of text that notices damage.
#pragma once

#include "core/base/secret_bytes.h"

#include <optional>
#include <string>
#include <string_view>

namespace skyseal::keys {

inline constexpr std::size_t kCheckedBase64Length = 48;

/// URL-safe base64 of the bytes and of the first four of BLAKE2b-256(label | bytes). Made and read in constant time,
/// since it may be a secret; then the caller wipes the text.
std::string toCheckedBase64(std::span<const std::uint8_t, 32> bytes, std::string_view label);

/// The bytes; nullopt for another length, other characters, or a check that does not fit.
std::optional<Key32> fromCheckedBase64(std::string_view text, std::string_view label);

} // namespace skyseal::keys
