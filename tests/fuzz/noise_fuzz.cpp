// Handshake messages from a stranger: the first byte picks the role and pattern, the rest are messages with a length in
// front of each. Whatever they are, reading them is safe, and nobody answers our first message without the
// pre-shared key.
#include "core/base/byte_reader.h"
#include "core/crypto/init_crypto.h"
#include "core/noise/handshake_state.h"

#include "tests/noise/fixed_random.h"

#include <algorithm>
#include <cstdlib>

using namespace skyseal;
using namespace skyseal::noise;

static HandshakeState victim(std::uint8_t choice)
{
    static constexpr std::string_view kPatterns[] = {kKnownPeers, "XXpsk3", "IK", "XX"};
    Key32 ours;
    ours.mutableView()[0] = 1;
    Key32 theirs;
    theirs.mutableView()[0] = 2;
    Key32 psk;
    psk.mutableView()[0] = 3;
    const Party role = choice & 1 ? Party::Responder : Party::Initiator;
    HandshakeConfig config{role, kPatterns[(choice >> 1) & 3], asBytes("fuzz"), {}, {}, {}};
    config.localStatic = X25519KeyPair::fromSecret(std::move(ours));
    if (config.role == Party::Initiator && config.pattern.starts_with("IK"))
        config.remoteStatic = X25519KeyPair::fromSecret(std::move(theirs)).publicKey;
    config.psks.push_back(std::move(psk));
    return std::move(*HandshakeState::initialize(std::move(config)));
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const bool ready = crypto::initCrypto();
    ByteReader reader(ByteView(data, size));
    const std::uint8_t choice = reader.u8();
    HandshakeState state = victim(choice);
    test::FixedRandom random(Bytes(64, 7));
    Bytes out(1024);
    while (ready && !reader.atEnd() && reader.ok() && !state.isComplete()) {
        if (state.isMyTurnToWrite()) {
            if (!state.writeMessage(asBytes("answer"), out, random))
                break; // the stranger's ephemeral key was a point of small order
            continue;
        }
        const std::size_t length = reader.u16();
        const ByteView message = reader.bytes(std::min(length, reader.remaining()));
        const std::size_t overhead = state.nextOverhead();
        const crypto::Hash64 before = state.handshakeHash();
        const auto read = state.readMessage(message, out);
        if (read ? *read + overhead != message.size() : state.handshakeHash() != before)
            std::abort();
    }
    // An initiator of IKpsk2 completes by reading; its peer would have had to know the psk.
    if (state.isComplete() && (choice & 7) == 0)
        std::abort();
    return 0;
}
