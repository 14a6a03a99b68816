// Messages in the payloads of MAVLink's TUNNEL, which hold 128 bytes. A message that is not longer is the payload. A longer
// one goes in two or three parts:
//
//   0x80 | last (1 bit) | index (2 bits)    set 2    up to 125 bytes of the message; all but the last part are full
//
// A first byte of 0x40-0x7F is a whole message, so the two cannot be confused. Parts are not authenticated before the
// message is whole: they cost a fixed amount of memory, and no more than a copy.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/wire_format.h"

#include <algorithm>
#include <array>
#include <optional>

namespace skyseal::channel {

/// Private use begins at 32768; experiments choose their own number.
inline constexpr std::uint16_t kTunnelPayloadType = 0xdea1;
inline constexpr std::size_t kTunnelPayload = 128;
inline constexpr std::size_t kPartHead = 3;
inline constexpr std::size_t kPartData = kTunnelPayload - kPartHead;
inline constexpr std::size_t kMaxParts = 3;
/// The longest frame of 280 bytes makes a record of 318 at the most.
inline constexpr std::size_t kMaxTunnelled = kPartData * kMaxParts;

/// Calls `send(ByteView payload)` for each part; `set` is another number for each message. False when it is too long.
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

/// The one message of a sender that is not whole yet.
class UnfinishedMessage
{
public:
    /// A set whose parts do not come within this time is given up; its number may mean another message by then.
    static constexpr Duration kKept = std::chrono::seconds(2);

    /// The whole message once its last missing part is there: to be changed in place, until the next call. nullopt before,
    /// and for what is no part. Another set takes the place of one that is unfinished.
    std::optional<MutableByteView> take(TimePoint now, ByteView payload);

private:
    std::array<std::uint8_t, kMaxTunnelled> m_bytes;
    std::uint16_t m_set = 0;
    std::uint8_t m_present = 0; ///< a bit for each index
    std::uint8_t m_count = 0;   ///< parts in all; 0 = the last one has not come
    std::size_t m_size = 0;     ///< of the whole, once the last one has come
    bool m_delivered = false;
    std::optional<TimePoint> m_since;
};

/// What came out of the payloads of several senders.
class TunnelReader
{
public:
    /// Senders whose long messages may be unfinished at the same time; of more, the one that was quiet longest starts again.
    static constexpr std::size_t kSenders = 16;

    /// The message that this payload is, or completes.
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
