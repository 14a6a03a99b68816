// Result of sealing frames, and the size limits of a record.
#pragma once

#include <cstddef>
#include <cstdint>

namespace skyseal::channel {

enum class SealError : std::uint8_t {
    NoSession,
    TooLong,
    Exhausted, ///< hard record limit of an epoch (PROTOCOL.md, section 6); the session ends
    NoRoom,    ///< the output buffer is too small
    NotFrames, ///< empty, or the first byte is below 0x10, which marks the channel's control messages
    NotInline, ///< this frame, or this session, cannot use inline framing; seal the frame in a record
};

/// Number of sealed bytes, or the error. One machine word, since every record returns it through three calls: a Result is
/// returned through memory, which costs 5 ns at each level.
class Sealed
{
public:
    Sealed(std::size_t size) : m_value(static_cast<std::int64_t>(size)) {}
    Sealed(SealError error) : m_value(-1 - static_cast<std::int64_t>(error)) {}

    bool has_value() const { return m_value >= 0; }
    explicit operator bool() const { return has_value(); }
    /// Precondition: has_value().
    std::size_t operator*() const { return static_cast<std::size_t>(m_value); }
    std::size_t value_or(std::size_t other) const { return has_value() ? **this : other; }
    /// Precondition: !has_value().
    SealError error() const { return static_cast<SealError>(-1 - m_value); }

private:
    std::int64_t m_value;
};

/// Upper bound of the bytes that a record adds to its frames.
inline constexpr std::size_t kMaxRecordOverhead = 42;
/// Most bytes of frames in one record: a datagram has at most 1200.
inline constexpr std::size_t kMaxRecordPayload = 1200 - kMaxRecordOverhead;

} // namespace skyseal::channel
