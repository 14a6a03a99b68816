// The one-shot functions of OpenSSL 3 cost several times the hash itself for messages this short, so the two or three
// blocks are padded here and given to the block function. It is marked deprecated as an interface, not as an algorithm.
#define OPENSSL_SUPPRESS_DEPRECATED
#include "core/mavlink/signing.h"

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

bool signatureMatches(const Frame &frame, const Key32 &key)
{
    if (!frame.isSigned())
        return false;
    const ByteView bytes = frame.bytes();
    const Digest digest = digestOf(key, bytes.first(bytes.size() - kDigestPart));
    return sodium_memcmp(digest.data(), bytes.last(kDigestPart).data(), kDigestPart) == 0;
}

std::uint8_t signatureLinkId(const Frame &frame)
{
    return frame.signatureBlock()[0];
}

SigningTime signatureTime(const Frame &frame)
{
    SigningTime time = 0;
    for (std::size_t i = 0; i < 6; ++i)
        time |= SigningTime(frame.signatureBlock()[1 + i]) << (8 * i);
    return time;
}

SignatureVerdict SignatureVerifier::check(const Frame &frame)
{
    const SignatureVerdict verdict = judge(frame);
    ++m_counts[static_cast<std::size_t>(verdict)];
    return verdict;
}

SignatureVerdict SignatureVerifier::judge(const Frame &frame)
{
    if (!frame.isSigned())
        return SignatureVerdict::Unsigned;
    if (!signatureMatches(frame, m_key))
        return SignatureVerdict::Wrong;
    const std::uint32_t id = std::uint32_t(signatureLinkId(frame)) << 16 | std::uint32_t(frame.systemId()) << 8
        | frame.componentId();
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
        if (m_streamCount == kMaxStreams)
            return SignatureVerdict::TooManyStreams;
        m_streams[m_streamCount++] = {id, time};
    }
    m_newest = std::max(m_newest, time);
    return SignatureVerdict::Good;
}

} // namespace skyseal::mavlink
