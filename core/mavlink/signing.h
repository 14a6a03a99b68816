// MAVLink 2 message signing in the standard format: https://mavlink.io/en/guide/message_signing.html
#pragma once

#include "core/base/clock.h"
#include "core/base/secret_bytes.h"
#include "core/mavlink/signature.h"

#include <algorithm>
#include <array>

namespace skyseal::mavlink {

/// 0 for moments before 2015.
SigningTime signingTime(WallTime time);

/// Signs the frames of one sender on one link. Its time increases strictly: each frame gets at least one unit
/// more than the one before. Store `lastTime()` across restarts and pass it to the constructor.
class FrameSigner
{
public:
    FrameSigner(Key32 key, std::uint8_t linkId, SigningTime start = 0) : m_key(std::move(key)), m_last(start), m_linkId(linkId)
    {}

    /// Advances the time to `now`, if that is later. Once per wake-up is enough.
    void advanceTo(SigningTime now) { m_last = std::max(m_last, std::min(now, kMaxSigningTime)); }
    SigningTime lastTime() const { return m_last; }

    /// Fills the signature block (the last 13 bytes) of a frame that was written with kFlagSigned. Returns false for other
    /// frames.
    bool sign(MutableByteView frame);
    /// Writes a signed copy of a whole MAVLink 2 frame of any message into `out` (kMaxFrameLength suffices); an existing
    /// signature is replaced. Empty if it cannot be signed: MAVLink 1, or all timestamps are used up.
    ByteView signCopy(ByteView frame, MutableByteView out);

private:
    Key32 m_key;
    SigningTime m_last;
    std::uint8_t m_linkId;
};

/// Fills the signature block with the given link id and time; for tools that reproduce a given frame.
bool signFrame(MutableByteView frame, const Key32 &key, std::uint8_t linkId, SigningTime time);

/// Returns true if the whole frame was signed with this key; its message may be unknown. Does not check for replay.
bool signatureMatches(ByteView frame, const Key32 &key);
inline bool signatureMatches(const Frame &frame, const Key32 &key)
{
    return signatureMatches(frame.bytes(), key);
}

/// Verifies frames with one key and keeps the last time of every stream (link id, system, component). Only frames with a
/// valid signature update these times.
class SignatureVerifier
{
public:
    static constexpr std::size_t kMaxStreams = 64;

    /// `now` = own time at the start; a new stream may not begin more than a minute before the newest time known.
    /// `mostStreams`: at most kMaxStreams.
    SignatureVerifier(Key32 key, SigningTime now, std::size_t mostStreams = kMaxStreams)
        : m_key(std::move(key)), m_newest(now), m_mostStreams(std::min(mostStreams, kMaxStreams))
    {}

    /// Advances the own time; times in signed frames do so as well.
    void advanceTo(SigningTime now) { m_newest = std::max(m_newest, now); }
    SigningTime newestTime() const { return m_newest; }

    /// `frame`: whole; its message may be unknown.
    SignatureVerdict check(ByteView frame);
    SignatureVerdict check(const Frame &frame) { return check(frame.bytes()); }

    std::uint64_t count(SignatureVerdict verdict) const { return m_counts[static_cast<std::size_t>(verdict)]; }

private:
    struct Stream
    {
        std::uint32_t id = 0;
        SigningTime last = 0;
    };

    SignatureVerdict judge(ByteView frame);

    Key32 m_key;
    SigningTime m_newest;
    std::array<Stream, kMaxStreams> m_streams;
    std::size_t m_mostStreams;
    std::size_t m_streamCount = 0;
    std::array<std::uint64_t, kSignatureVerdicts> m_counts{};
};

} // namespace skyseal::mavlink
