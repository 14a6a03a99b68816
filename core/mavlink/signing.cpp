// The one-shot functions of OpenSSL 3 cost several times the hash itself for messages this short, so the two or three
// blocks are padded here and given to the block function. It is marked deprecated as an interface, not as an algorithm.
#define OPENSSL_SUPPRESS_DEPRECATED
#include "core/mavlink/signing.h"

#include "core/mavlink/crc.h"
#include "core/mavlink/frame_header.h"

#include <openssl/sha.h>
#include <sodium.h>

#include <algorithm>
#include <cstring>

namespace skyseal::mavlink {

namespace {

constexpr std::size_t kDigestPart = 6;
constexpr std::size_t kBlock = 64;
constexpr std::size_t kPadding = 9; // one bit and the length
constexpr std::size_t kMaxHashed = 32 + kMaxFrameLength;
constexpr std::size_t kBuffer = (kMaxHashed + kPadding + kBlock - 1) / kBlock * kBlock;

constexpr std::size_t kFlagsAt = 2; // of the incompatibility flags
constexpr std::size_t kHeader = 10; // of MAVLink 2
constexpr std::size_t kChecksum = 2;

/// kFlagEffect[n]: the bits of the checksum of a frame with n bytes of payload that change when kFlagSigned changes. A CRC is
/// linear, so this needs neither the payload nor the CRC_EXTRA of a message that the dialect does not know.
constexpr std::array<std::uint16_t, 256> kFlagEffect = [] {
    std::uint16_t effect = crcStep(0, kFlagSigned);
    for (std::size_t after = kFlagsAt + 1; after < kHeader + 1; ++after) // the rest of the header, and CRC_EXTRA
        effect = crcStep(effect, 0);
    std::array<std::uint16_t, 256> table{};
    for (std::uint16_t &entry : table) {
        entry = effect;
        effect = crcStep(effect, 0);
    }
    return table;
}();

using Digest = std::array<std::uint8_t, kDigestPart>;

/// SHA-256 over the key and the frame up to its signature, cut to 48 bits. `signedPart` is at most kMaxFrameLength long.
Digest digestOf(const Key32 &key, ByteView signedPart)
{
    alignas(16) std::uint8_t buffer[kBuffer];
    const std::size_t length = key.size() + signedPart.size();
    const std::size_t padded = (length + kPadding + kBlock - 1) / kBlock * kBlock;
    std::memcpy(buffer, key.view().data(), key.size());
    std::memcpy(buffer + key.size(), signedPart.data(), signedPart.size());
    buffer[length] = 0x80;
    std::memset(buffer + length + 1, 0, padded - length - 1);
    for (std::size_t i = 0; i < 4; ++i)
        buffer[padded - 1 - i] = static_cast<std::uint8_t>((length * 8) >> (8 * i));

    SHA256_CTX context;
    SHA256_Init(&context);
    for (std::size_t at = 0; at < padded; at += kBlock)
        SHA256_Transform(&context, buffer + at);
    sodium_memzero(buffer, key.size());
    return {static_cast<std::uint8_t>(context.h[0] >> 24), static_cast<std::uint8_t>(context.h[0] >> 16),
            static_cast<std::uint8_t>(context.h[0] >> 8),  static_cast<std::uint8_t>(context.h[0]),
            static_cast<std::uint8_t>(context.h[1] >> 24), static_cast<std::uint8_t>(context.h[1] >> 16)};
}

} // namespace

SigningTime signingTime(WallTime time)
{
    constexpr std::int64_t kEpoch = 1'420'070'400; // 2015-01-01 in seconds since 1970
    const std::int64_t units = time.time_since_epoch().count() / 10 - kEpoch * 100'000;
    return units > 0 ? std::min(static_cast<SigningTime>(units), kMaxSigningTime) : 0;
}

bool signFrame(MutableByteView frame, const Key32 &key, std::uint8_t linkId, SigningTime time)
{
    if (frame.size() < 12 + kSignatureLength || frame.size() > kMaxFrameLength || frame[0] != kMagic2
        || !(frame[2] & kFlagSigned) || frame.size() != std::size_t(frame[1]) + 12 + kSignatureLength)
        return false;
    const MutableByteView block = frame.last(kSignatureLength);
    block[0] = linkId;
    for (std::size_t i = 0; i < 6; ++i)
        block[1 + i] = static_cast<std::uint8_t>(time >> (8 * i));
    const Digest digest = digestOf(key, frame.first(frame.size() - kDigestPart));
    std::copy(digest.begin(), digest.end(), block.begin() + 7);
    return true;
}

bool FrameSigner::sign(MutableByteView frame)
{
    if (m_last >= kMaxSigningTime || !signFrame(frame, m_key, m_linkId, m_last + 1))
        return false;
    ++m_last;
    return true;
}

ByteView FrameSigner::signCopy(ByteView frame, MutableByteView out)
{
    if (frame[0] != kMagic2)
        return {};
    const std::size_t length = kHeader + frame[1] + kChecksum;
    if (frame.size() < length || out.size() < length + kSignatureLength)
        return {};
    std::memcpy(out.data(), frame.data(), length);
    if (!isSignedFrame(frame)) {
        const std::uint16_t effect = kFlagEffect[frame[1]];
        out[kFlagsAt] |= kFlagSigned;
        out[length - 2] ^= static_cast<std::uint8_t>(effect);
        out[length - 1] ^= static_cast<std::uint8_t>(effect >> 8);
    }
    const MutableByteView copy = out.first(length + kSignatureLength);
    return sign(copy) ? ByteView(copy) : ByteView();
}

bool signatureMatches(ByteView frame, const Key32 &key)
{
    if (!isSignedFrame(frame))
        return false;
    const Digest digest = digestOf(key, frame.first(frame.size() - kDigestPart));
    return sodium_memcmp(digest.data(), frame.last(kDigestPart).data(), kDigestPart) == 0;
}

std::uint8_t signatureLinkId(ByteView frame)
{
    return frame.last(kSignatureLength)[0];
}

SigningTime signatureTime(ByteView frame)
{
    const ByteView block = frame.last(kSignatureLength);
    SigningTime time = 0;
    for (std::size_t i = 0; i < 6; ++i)
        time |= SigningTime(block[1 + i]) << (8 * i);
    return time;
}

SignatureVerdict SignatureVerifier::check(ByteView frame)
{
    const SignatureVerdict verdict = judge(frame);
    ++m_counts[static_cast<std::size_t>(verdict)];
    return verdict;
}

SignatureVerdict SignatureVerifier::judge(ByteView frame)
{
    if (!isSignedFrame(frame))
        return SignatureVerdict::Unsigned;
    if (!signatureMatches(frame, m_key))
        return SignatureVerdict::Wrong;
    const std::uint32_t id = std::uint32_t(signatureLinkId(frame)) << 16 | std::uint32_t(systemIdOf(frame)) << 8
        | componentIdOf(frame);
    const SigningTime time = signatureTime(frame);
    const auto end = m_streams.begin() + static_cast<std::ptrdiff_t>(m_streamCount);
    const auto stream = std::find_if(m_streams.begin(), end, [id](const Stream &known) { return known.id == id; });
    if (stream != end) {
        if (time <= stream->last)
            return SignatureVerdict::Replayed;
        stream->last = time;
    } else {
        if (time + kSigningMinute < m_newest)
            return SignatureVerdict::TooOld;
        if (m_streamCount == m_mostStreams)
            return SignatureVerdict::TooManyStreams;
        m_streams[m_streamCount++] = {id, time};
    }
    m_newest = std::max(m_newest, time);
    return SignatureVerdict::Good;
}

} // namespace skyseal::mavlink
