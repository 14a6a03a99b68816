// The formats of the handshake's messages (PROTOCOL.md, section 4), for code that needs only their lengths. Their content is in
// handshake.h.
#pragma once

#include "core/channel/handshake_payload.h"
#include "core/channel/mac1.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace skyseal::channel {

inline constexpr std::size_t kFirstNoiseLength = 32 + 48 + FirstPayload::kLength + 16;
inline constexpr std::size_t kAnswerNoiseLength = 32 + AnswerPayload::kLength + 16;
inline constexpr std::size_t kNumberNoiseLength = 32 + NumberPayload::kLength + 16;
inline constexpr std::size_t kFirstLength = 1 + kFirstNoiseLength + kMacLength;
inline constexpr std::size_t kAnswerLength = 3 + kAnswerNoiseLength + kMacLength;
inline constexpr std::size_t kNumberLength = 3 + kNumberNoiseLength + kMacLength;
static_assert(kFirstLength == 127 && kAnswerLength == 77 && kNumberLength == 72, "as PROTOCOL.md says");
static_assert(Announcement::kLength >= kFirstLength, "a first message must not be longer than the announcement it answers");

using FirstMessage = std::array<std::uint8_t, kFirstLength>;
using AnswerMessage = std::array<std::uint8_t, kAnswerLength>;
using NumberMessage = std::array<std::uint8_t, kNumberLength>;

} // namespace skyseal::channel
