// Pairing messages in every state of both roles: a window without callers, one that waits for an answer or an opening, and one
// with a peer on the screen. The input is a list of datagrams, each a length and its bytes; heads are made valid.
#include "core/crypto/passphrase.h"
#include "core/crypto/init_crypto.h"
#include "pairing_pair.h"

#include <cstdlib>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// Puts the present token and pairing id where they belong, so that the fuzzer gets past the comparison.
void makeGood(Bytes &datagram, const PairingToken &token, const std::array<std::uint8_t, 4> &id)
{
    if (datagram.size() < 22)
        return;
    std::copy(id.begin(), id.end(), datagram.begin() + 1);
    if (datagram[0] == 0x5d)
        std::copy(token.begin(), token.end(), datagram.begin() + 5);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const bool ready = crypto::initCrypto();
    if (!ready || size < 2)
        return 0;
    const std::uint8_t how = data[0];
    PairingPair pair;
    PairingToken token{};
    std::array<std::uint8_t, 4> id{};
    pair.link.attacker = [&](TimePoint, SentDatagram &flight) {
        if (const auto called = calledToken(flight.bytes))
            token = *called;
        else
            std::copy_n(flight.bytes.begin() + 1, 4, id.begin());
        // Held up at one step of the handshake, by the input.
        return !(((how & 4) && flight.bytes[0] == 0x5d) || ((how & 8) && flight.bytes[0] == 0x5e)
                 || ((how & 16) && flight.bytes[0] == 0x5f));
    };
    if (how & 128)
        pair.letAirListen();
    pair.openBoth();
    pair.run(std::chrono::milliseconds(how & 32 ? 0 : 600));
    if (how & 64)
        pair.confirm(Air);

    const Side to = how & 1 ? Air : Ground;
    const Path from = PairingPair::pathOf(to == Air ? Ground : Air);
    std::size_t at = 1;
    for (int count = 0; at < size && count < 16; ++count) {
        const std::size_t length = std::min<std::size_t>(data[at], size - at - 1);
        Bytes datagram(data + at + 1, data + at + 1 + length);
        at += 1 + length;
        if (how & 2)
            makeGood(datagram, token, id);
        pair.ends[to].pairing->handleDatagram(pair.now, from, datagram);
        pair.pump();
        pair.run(std::chrono::milliseconds(100));
    }
    // Without the handshake there is no pairing, no confirmation, and no peer on the screen.
    for (const PairingSide &end : pair.ends) {
        if (!end.all<Paired>().empty())
            std::abort();
    }
    if (pair.ground().pairing->confirmedThere() && !(how & 64))
        std::abort();
    if (pair.air().pairing->confirmedThere())
        std::abort();
    if (pair.ground().pairing->peer() && !pair.ground().sees(publicKeyOf(*pair.air().identity)))
        std::abort();
    if (pair.air().pairing->peer() && !pair.air().sees(publicKeyOf(*pair.ground().identity)))
        std::abort();
    PairingOpening::Bytes opening{};
    std::copy_n(data, std::min(size, opening.size()), opening.begin());
    if (PairingOpening::read(opening).name.size() > kMaxPairingName)
        std::abort();
    return 0;
}
