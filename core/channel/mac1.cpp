#include "core/channel/mac1.h"

#include "core/crypto/hash.h"

#include <sodium.h>

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr std::size_t kAnnouncedNonce = 16;
constexpr std::size_t kCovered = 1 + kAnnouncedNonce; ///< bytes of an announcement that its MAC covers

using Mac = std::array<std::uint8_t, kMacLength>;

std::array<std::uint8_t, 32> keyFor(std::string_view use, const PublicKey &key)
{
    std::array<std::uint8_t, 32> out;
    crypto::blake2b(out, {asBytes("skyseal v1 "), asBytes(use), key});
    return out;
}

Mac macOver(ByteView key, ByteView said)
{
    Mac mac;
    crypto::keyedBlake2b(mac, key, {said});
    return mac;
}

bool equal(const Mac &expected, ByteView found)
{
    return found.size() == expected.size() && sodium_memcmp(expected.data(), found.data(), expected.size()) == 0;
}

} // namespace

Mac1::Mac1(const PublicKey &addressee) : m_key(keyFor("mac1", addressee)) {}

void Mac1::sign(MutableByteView message) const
{
    const std::size_t said = message.size() - kMacLength;
    const Mac mac = macOver(m_key, message.first(said));
    std::copy(mac.begin(), mac.end(), message.begin() + static_cast<std::ptrdiff_t>(said));
}

bool Mac1::verify(ByteView message) const
{
    if (message.size() < kMacLength)
        return false;
    const std::size_t said = message.size() - kMacLength;
    return equal(macOver(m_key, message.first(said)), message.subspan(said));
}

Announcement::Announcement(const PublicKey &agent) : m_key(keyFor("announcement", agent)) {}

Announcement::Datagram Announcement::make(RandomSource &random) const
{
    Datagram out{};
    out[0] = firstByte(HandshakeMessage::Announcement);
    random.fill(MutableByteView(out).subspan(1, kAnnouncedNonce));
    const Mac mac = macOver(m_key, ByteView(out).first(kCovered));
    std::copy(mac.begin(), mac.end(), out.begin() + kCovered);
    return out;
}

bool Announcement::hasForm(ByteView datagram)
{
    return datagram.size() == kLength && datagram[0] == firstByte(HandshakeMessage::Announcement)
        && std::all_of(datagram.begin() + kCovered + kMacLength, datagram.end(), [](std::uint8_t byte) { return byte == 0; });
}

bool Announcement::recognises(ByteView datagram) const
{
    return datagram.size() == kLength
        && equal(macOver(m_key, datagram.first(kCovered)), datagram.subspan(kCovered, kMacLength));
}

} // namespace skyseal::channel
