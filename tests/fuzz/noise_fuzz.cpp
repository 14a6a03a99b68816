// Handshake messages from a stranger: the first byte picks the role, the rest are messages with a length in front of each.
// Whatever they are, reading them is safe and changes nothing unless one is accepted. An initiator accepts none, since its peer
// would have to know the pre-shared key.
#include "core/base/byte_reader.h"
#include "core/crypto/init_crypto.h"
#include "core/noise/handshake_state.h"

#include "tests/noise/fixed_random.h"

#include <algorithm>
#include <cstdlib>

using namespace skyseal;
using namespace skyseal::noise;

namespace {

void must(bool holds)
{
    if (!holds)
        std::abort();
}

Key32 keyOf(std::uint8_t value)
{
    Key32 key;
    key.mutableView()[0] = value;
    return key;
}

X25519KeyPair pairOf(std::uint8_t value)
{
    return X25519KeyPair::fromSecret(keyOf(value));
}

/// A handshake with the peer that knows the pre-shared key.
struct Handshake
{
    HandshakeState initiator = HandshakeState::initiator(asBytes("fuzz"), pairOf(2), pairOf(1).publicKey);
    HandshakeState responder = HandshakeState::responder(asBytes("fuzz"), pairOf(1));
    test::FixedRandom random{Bytes(64, 7)};
    Bytes first = Bytes(kFirstOverhead);
    Bytes second = Bytes(kSecondOverhead);

    Handshake()
    {
        initiator.setPsk(keyOf(3));
        responder.setPsk(keyOf(3));
        must(initiator.writeMessage({}, first, random).has_value());
    }
};

/// True if one of the messages is accepted; the others after it are not read.
bool acceptsOneOf(ByteReader &messages, HandshakeState &state)
{
    Bytes out(1024);
    while (!messages.atEnd() && messages.ok()) {
        const std::size_t length = messages.u16();
        if (state.readMessage(messages.bytes(std::min(length, messages.remaining())), out))
            return true;
    }
    return false;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    must(crypto::initCrypto());
    ByteReader reader(ByteView(data, size));
    const bool toResponder = reader.u8() & 1;
    Handshake ends;
    if (toResponder && acceptsOneOf(reader, ends.responder)) {
        must(ends.responder.writeMessage({}, ends.second, ends.random).has_value());
        must(std::move(ends.responder).finish().has_value());
        return 0;
    }
    must(toResponder || !acceptsOneOf(reader, ends.initiator));
    must(ends.responder.readMessage(ends.first, {}).has_value());
    must(ends.responder.writeMessage({}, ends.second, ends.random).has_value());
    must(ends.initiator.readMessage(ends.second, {}).has_value());
    return 0;
}
