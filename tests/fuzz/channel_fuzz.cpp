// Messages into a live session whose keys the fuzzer has, in any carrier: the input is a list of operations, so that it
// reaches the control messages behind the decryption, the switch, and time. Whatever comes, nothing is delivered that was
// not sealed.
#include "pair.h"

#include "core/base/byte_reader.h"
#include "core/channel/endpoint.h"
#include "core/channel/handshake.h"
#include "core/channel/record.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/record_cipher.h"

#include <cstdlib>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

/// Takes part in the session as the station, after the handshake that its endpoint made: the same keys, but whatever
/// plaintext the fuzzer wants.
struct Insider
{
    explicit Insider(RandomSource &random)
        : identity(crypto::X25519KeyPair::generate(random)), agent(crypto::X25519KeyPair::generate(random))
    {}
    crypto::X25519KeyPair identity;
    crypto::X25519KeyPair agent;
    std::unique_ptr<crypto::RecordCipher> writer;
    ConnectionId theirs{};
    std::uint32_t counter = 0;
    Carrier carrier{};

    bool enter(Endpoint &endpoint, TimePoint now, const Path &path, RandomSource &random)
    {
        carrier = path.carrier;
        const SuiteOffer offer = offerOf(Policy{defaultSuites(), true, true});
        Peer peer;
        peer.key = agent.publicKey;
        auto initiator = Initiator::begin(identity, peer, {ConnectionId{1}, offer, 1}, random, carrier);
        Bytes first(initiator->message().begin(), initiator->message().end());
        endpoint.handleDatagram(now, path, first);
        while (const auto transmit = endpoint.pollTransmit()) {
            auto agreement = initiator->readAnswer(transmit->bytes);
            if (!agreement)
                continue;
            theirs = agreement->peerConnection;
            auto secrets = agreement->chain.begin(agreement->suite);
            writer = crypto::makeRecordCipher(agreement->suite, std::move(secrets.fromInitiator));
            return true;
        }
        return false;
    }

    Bytes seal(ByteView plaintext, DatagramKind kind)
    {
        const RecordHeader header{kind, 0, theirs, counter};
        Bytes out(header.length() + writer->sealedSize(plaintext.size()));
        header.write(out);
        const AssociatedData associated(ByteView(out).first(header.length()), writer->suite(), Direction::FromInitiator,
                                        carrier);
        writer->seal(counter++, associated.view(), plaintext, MutableByteView(out).subspan(header.length()));
        return out;
    }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const bool ready = crypto::initCrypto();
    if (!ready)
        std::abort();
    SeededRandom random(1);
    MemoryCounterStore counters;
    Insider insider(random);
    Config config;
    config.role = Role::Agent;
    config.identity = std::make_shared<crypto::X25519KeyPair>(insider.agent.clone());
    Peer station;
    station.key = insider.identity.publicKey;
    config.peers = {station};
    config.policy = {defaultSuites(), true, true};
    ByteReader in(ByteView(data, size));
    const Path path{LinkId{1}, {}, static_cast<Carrier>(1 + in.u8() % 3)};
    TimePoint now{1h};
    Endpoint endpoint(std::move(config), random, counters, now);
    if (!insider.enter(endpoint, now, path, random))
        std::abort();

    std::size_t framesSealed = 0, framesOpened = 0;
    while (!in.atEnd() && in.ok()) {
        const std::uint8_t operation = in.u8();
        const DatagramKind kind = operation & 0x80 ? DatagramKind::SingleRecord : DatagramKind::Record;
        const ByteView bytes = in.bytes(std::min<std::size_t>(in.u8(), in.remaining()));
        switch (operation % 5) {
        case 0: { // anything at all
            Bytes datagram(bytes.begin(), bytes.end());
            if (endpoint.handleDatagram(now, path, datagram))
                std::abort();
            break;
        }
        case 1: { // sealed with the right keys
            Bytes datagram = insider.seal(bytes, kind);
            const bool frames = !isControl(bytes);
            framesSealed += frames;
            framesOpened += endpoint.handleDatagram(now, path, datagram).has_value();
            break;
        }
        case 2: // time passes
            now += std::chrono::milliseconds(operation * 10);
            endpoint.handleDeadline(now);
            break;
        case 3: // the owner acts
            for (const SessionId session : endpoint.sessions())
                endpoint.switchSuite(now, session, crypto::suites()[operation % crypto::suites().size()].id);
            break;
        default: { // a right record, one byte changed
            Bytes datagram = insider.seal(bytes, kind);
            datagram[operation % datagram.size()] ^= static_cast<std::uint8_t>(1 + operation % 255);
            if (endpoint.handleDatagram(now, path, datagram))
                std::abort();
        }
        }
        while (endpoint.pollTransmit())
            continue;
        while (endpoint.pollEvent())
            continue;
    }
    if (framesOpened > framesSealed)
        std::abort();
    return 0;
}
