// Messages in the payloads of MAVLink's TUNNEL, of 128 bytes each (PROTOCOL.md, section 2.1). A message of at most that length
// is the payload. A longer one is sent in two or three parts:
//
//   0x80 | last (1 bit) | index (2 bits)    set 2    up to 125 bytes of the message; all but the last part are full
//
// A payload with a first byte of 0x40-0x7F is a whole message. Parts are not authenticated before the message is complete: they
// cost a fixed amount of memory, and no more than a copy.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/wire_format.h"

#include <algorithm>
#include <array>
#include <optional>

namespace skyseal::channel {

/// Of the range for private use, which begins at 32768.
inline constexpr std::uint16_t kTunnelPayloadType = 0xdea1;
inline constexpr std::size_t kTunnelPayload = 128;
inline constexpr std::size_t kPartHead = 3;
inline constexpr std::size_t kPartData = kTunnelPayload - kPartHead;
inline constexpr std::size_t kMaxParts = 3;
/// The longest frame, 280 bytes, makes a record of at most 310 bytes.
inline constexpr std::size_t kMaxTunnelled = kPartData * kMaxParts;

/// MAVLink truncates trailing zeros of a payload, including those that make an announcement as long as its answer. Handshake
/// and pairing messages of 127 bytes are therefore followed by a byte that is never zero, the last one of the payload. Without
/// it they are rejected, so that a forged source address yields no amplification.
inline constexpr std::size_t kPaddedLength = kTunnelPayload - 1;
inline constexpr std::uint8_t kTunnelPadding = 0xff;
constexpr bool isPadded(ByteView message)
{
    return message.size() == kPaddedLength
        && (kindOf(message[0]) == DatagramKind::Handshake || kindOf(message[0]) == DatagramKind::Pairing);
}

/// Calls `send(ByteView payload)` for each part. `set` differs for each message. Returns false if the message is too long.
template<typename Send> bool writeParts(ByteView message, std::uint16_t set, Send &&send)
{
    if (message.empty() || message.size() > kMaxTunnelled)
        return false;
    if (message.size() <= kTunnelPayload) {
        send(message);
        return true;
    }
    std::array<std::uint8_t, kTunnelPayload> payload;
    for (std::uint8_t index = 0; !message.empty(); ++index) {
        const ByteView data = message.first(std::min(message.size(), kPartData));
        message = message.subspan(data.size());
        payload[0] = static_cast<std::uint8_t>(0x80 | (message.empty() ? 4 : 0) | index);
        payload[1] = static_cast<std::uint8_t>(set);
        payload[2] = static_cast<std::uint8_t>(set >> 8);
        std::copy(data.begin(), data.end(), payload.begin() + kPartHead);
        send(ByteView(payload).first(kPartHead + data.size()));
    }
    return true;
}

/// The incomplete message of one sender.
class UnfinishedMessage
{
public:
    /// Time-out of an incomplete set, since its number may return for another message.
    static constexpr Duration kKept = std::chrono::seconds(2);

    /// Returns the message when its last missing part has arrived; it may be changed in place until the next call. Returns
    /// nullopt before, and for invalid parts. A part of another set replaces an incomplete one.
    std::optional<MutableByteView> take(TimePoint now, ByteView payload);

private:
    std::array<std::uint8_t, kMaxTunnelled> m_bytes;
    std::uint16_t m_set = 0;
    std::uint8_t m_present = 0; ///< a bit for each index
    std::uint8_t m_count = 0;   ///< number of parts; 0 = the last one has not arrived
    std::size_t m_size = 0;     ///< of the message, known when the last part has arrived
    bool m_delivered = false;
    std::optional<TimePoint> m_since;
};

/// Messages from the payloads of several senders.
class TunnelReader
{
public:
    /// Senders that may have an incomplete message; for one more, that of the sender that has been silent longest is dropped.
    static constexpr std::size_t kSenders = 16;

    /// Returns the message that this payload is or completes.
    std::optional<MutableByteView> take(TimePoint now, const Path &from, ByteView payload);

private:
    struct Sender
    {
        Path path;
        TimePoint heard = TimePoint::min();
        UnfinishedMessage message;
    };

    std::array<Sender, kSenders> m_senders{};
    std::array<std::uint8_t, kTunnelPayload> m_whole;
};

} // namespace skyseal::channel
