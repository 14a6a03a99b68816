// Requirements on the handshake beyond the published vector: every modified message is rejected, and a rejected message leaves
// the state unchanged.
#include "core/crypto/init_crypto.h"
#include "core/noise/handshake_state.h"
#include "tests/support/test_runner.h"

#include "tests/crypto/seeded_random.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::noise;

namespace {

using Attempted = Result<void, NoiseError>;

Key32 pskOf(std::uint8_t value)
{
    Key32 key;
    key.mutableView()[0] = value;
    return key;
}

Attempted read(HandshakeState &side, const Bytes &message, Bytes *payload = nullptr)
{
    Bytes out(message.size());
    const Attempted result = side.readMessage(message, out);
    if (payload)
        *payload = out;
    return result;
}

/// Both ends of a handshake, with options for wrong configurations.
struct Ends
{
    test::SeededRandom random{11};
    X25519KeyPair initiatorKeys = X25519KeyPair::generate(random);
    X25519KeyPair responderKeys = X25519KeyPair::generate(random);
    std::string initiatorPrologue = "prologue";
    std::uint8_t initiatorPsk = 1;

    HandshakeState initiator() const
    {
        auto state = HandshakeState::initiator(asBytes(initiatorPrologue), initiatorKeys.clone(), responderKeys.publicKey);
        state.setPsk(pskOf(initiatorPsk));
        return state;
    }
    HandshakeState responder() const
    {
        auto state = HandshakeState::responder(asBytes("prologue"), responderKeys.clone());
        state.setPsk(pskOf(1));
        return state;
    }

    Bytes first(HandshakeState &initiator, const Bytes &payload = {}) { return write(initiator, payload, kFirstOverhead); }
    Bytes second(HandshakeState &responder, const Bytes &payload = {}) { return write(responder, payload, kSecondOverhead); }

private:
    Bytes write(HandshakeState &side, const Bytes &payload, std::size_t overhead)
    {
        Bytes out(payload.size() + overhead);
        return side.writeMessage(payload, out, random) ? out : Bytes();
    }
};

/// Offers `message` with every bit flipped, cut at every length and with a byte more.
void offerForgeries(HandshakeState &receiver, const Bytes &message)
{
    for (std::size_t bit = 0; bit < message.size() * 8; ++bit) {
        Bytes forged = message;
        forged[bit / 8] = static_cast<std::uint8_t>(forged[bit / 8] ^ (1 << (bit % 8)));
        // The top bit of a Curve25519 point is ignored by the curve, but not by the hash.
        QVERIFY2(!read(receiver, forged), std::to_string(bit).c_str());
    }
    for (std::size_t size = 0; size < message.size(); ++size)
        QVERIFY(!read(receiver, Bytes(message.begin(), message.begin() + std::ptrdiff_t(size))));
    Bytes longer = message;
    longer.push_back(0);
    QCOMPARE(read(receiver, longer).error(), NoiseError::DecryptionFailed);
}

} // namespace

class HandshakeStateTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void agreesOnTransportSecrets();
    void refusalsChangeNothing();
    void setupsThatDifferFail();
    void pskIsChosenAfterTheFirstMessage();
    void failsWithoutPsk();
    void refusesPointsOfSmallOrder();
    void keepsToTheTurns();
    void finishesOnceAndOnlyAtTheEnd();
    void doesNothingAfterAMove();
    void limitsLengths();
    void cipherStateStopsBeforeTheLastNonce();
};

void HandshakeStateTest::agreesOnTransportSecrets()
{
    Ends ends;
    HandshakeState initiator = ends.initiator();
    HandshakeState responder = ends.responder();
    QVERIFY(!responder.remoteStatic());
    const Bytes asked = ends.random.bytes(31), answered = ends.random.bytes(17);
    Bytes received(asked.size());
    QVERIFY(responder.readMessage(ends.first(initiator, asked), received));
    QCOMPARE(received, asked);
    received.resize(answered.size());
    QVERIFY(initiator.readMessage(ends.second(responder, answered), received));
    QCOMPARE(received, answered);
    QCOMPARE(initiator.remoteStatic().value(), ends.responderKeys.publicKey);
    QCOMPARE(responder.remoteStatic().value(), ends.initiatorKeys.publicKey);
    const auto one = std::move(initiator).finish();
    const auto other = std::move(responder).finish();
    QVERIFY(one && other);
    QCOMPARE(one->handshakeHash, other->handshakeHash);
    QVERIFY(one->send.equals(other->receive) && one->receive.equals(other->send));
    QVERIFY(!one->send.equals(one->receive) && !one->send.isZero() && !one->receive.isZero());
}

void HandshakeStateTest::refusalsChangeNothing()
{
    Ends ends;
    HandshakeState initiator = ends.initiator();
    HandshakeState responder = ends.responder();
    const Bytes payload = ends.random.bytes(20);
    const Bytes first = ends.first(initiator, payload);
    offerForgeries(responder, first);
    QVERIFY(!responder.remoteStatic());
    Bytes received(payload.size());
    QVERIFY(responder.readMessage(first, received)); // after all rejected messages
    QCOMPARE(received, payload);

    const Bytes second = ends.second(responder, payload);
    offerForgeries(initiator, second);
    received.assign(payload.size(), 0);
    QVERIFY(initiator.readMessage(second, received));
    QCOMPARE(received, payload);

    const auto one = std::move(initiator).finish();
    const auto other = std::move(responder).finish();
    QVERIFY(one && other);
    QCOMPARE(one->handshakeHash, other->handshakeHash);
    QVERIFY(one->send.equals(other->receive) && one->receive.equals(other->send));
}

void HandshakeStateTest::setupsThatDifferFail()
{
    Ends prologue;
    prologue.initiatorPrologue = "prologuf";
    HandshakeState initiator = prologue.initiator();
    HandshakeState responder = prologue.responder();
    QCOMPARE(read(responder, prologue.first(initiator)).error(), NoiseError::DecryptionFailed);

    Ends psk;
    psk.initiatorPsk = 2;
    initiator = psk.initiator();
    responder = psk.responder();
    QVERIFY(read(responder, psk.first(initiator)));
    QCOMPARE(read(initiator, psk.second(responder)).error(), NoiseError::DecryptionFailed);

    Ends wrongPeer;
    initiator = wrongPeer.initiator();
    wrongPeer.responderKeys = X25519KeyPair::generate(wrongPeer.random);
    responder = wrongPeer.responder();
    QCOMPARE(read(responder, wrongPeer.first(initiator)).error(), NoiseError::DecryptionFailed);
    QVERIFY(!responder.remoteStatic());
}

void HandshakeStateTest::pskIsChosenAfterTheFirstMessage()
{
    Ends ends;
    HandshakeState initiator = ends.initiator();
    HandshakeState responder = ends.responder();
    responder.setPsk(pskOf(2));
    QVERIFY(read(responder, ends.first(initiator)));
    QCOMPARE(responder.remoteStatic().value(), ends.initiatorKeys.publicKey);
    responder.setPsk(pskOf(1));
    QVERIFY(read(initiator, ends.second(responder)));
}

void HandshakeStateTest::failsWithoutPsk()
{
    Ends ends;
    auto initiator = HandshakeState::initiator(asBytes("prologue"), ends.initiatorKeys.clone(), ends.responderKeys.publicKey);
    auto responder = HandshakeState::responder(asBytes("prologue"), ends.responderKeys.clone());
    QVERIFY(read(responder, ends.first(initiator)));
    Bytes out(kSecondOverhead);
    QCOMPARE(responder.writeMessage({}, out, ends.random).error(), NoiseError::MissingKey);
    responder.setPsk(Key32()); // zeros, which are not the same as none
    const Bytes second = ends.second(responder);
    QCOMPARE(read(initiator, second).error(), NoiseError::MissingKey);
    initiator.setPsk(Key32());
    QVERIFY(read(initiator, second));
}

void HandshakeStateTest::refusesPointsOfSmallOrder()
{
    Ends ends;
    HandshakeState responder = ends.responder();
    QCOMPARE(read(responder, Bytes(kFirstOverhead)).error(), NoiseError::BadPublicKey); // an ephemeral key of zeros
    HandshakeState initiator = ends.initiator();
    QVERIFY(read(responder, ends.first(initiator)));
    QCOMPARE(read(initiator, Bytes(kSecondOverhead)).error(), NoiseError::BadPublicKey);
    QVERIFY(read(initiator, ends.second(responder)));

    ends.initiatorKeys.publicKey = {}; // the static key that the first message contains
    initiator = ends.initiator();
    responder = ends.responder();
    QCOMPARE(read(responder, ends.first(initiator)).error(), NoiseError::BadPublicKey);
    ends.responderKeys.publicKey = {};
    initiator = ends.initiator();
    Bytes out(kFirstOverhead);
    QCOMPARE(initiator.writeMessage({}, out, ends.random).error(), NoiseError::BadPublicKey);
}

void HandshakeStateTest::keepsToTheTurns()
{
    Ends ends;
    HandshakeState initiator = ends.initiator();
    HandshakeState responder = ends.responder();
    Bytes out(200);
    QCOMPARE(responder.writeMessage({}, out, ends.random).error(), NoiseError::OutOfTurn);
    QCOMPARE(read(initiator, Bytes(100)).error(), NoiseError::OutOfTurn);
    const Bytes first = ends.first(initiator);
    QCOMPARE(initiator.writeMessage({}, out, ends.random).error(), NoiseError::OutOfTurn);
    QVERIFY(read(responder, first));
    QCOMPARE(read(responder, first).error(), NoiseError::OutOfTurn);
    const Bytes second = ends.second(responder);
    QVERIFY(read(initiator, second));
    for (HandshakeState *side : {&initiator, &responder}) {
        QCOMPARE(read(*side, first).error(), NoiseError::OutOfTurn);
        QCOMPARE(read(*side, second).error(), NoiseError::OutOfTurn);
        QCOMPARE(side->writeMessage({}, out, ends.random).error(), NoiseError::OutOfTurn);
    }
}

void HandshakeStateTest::finishesOnceAndOnlyAtTheEnd()
{
    Ends ends;
    HandshakeState early = ends.initiator();
    QCOMPARE(std::move(early).finish().error(), NoiseError::Unfinished);
    HandshakeState half = ends.initiator();
    HandshakeState halfRead = ends.responder();
    QVERIFY(read(halfRead, ends.first(half)));
    QCOMPARE(std::move(half).finish().error(), NoiseError::Unfinished);
    QCOMPARE(std::move(halfRead).finish().error(), NoiseError::Unfinished);

    HandshakeState initiator = ends.initiator();
    HandshakeState responder = ends.responder();
    QVERIFY(read(responder, ends.first(initiator)) && read(initiator, ends.second(responder)));
    QVERIFY(std::move(initiator).finish().has_value());
    // NOLINTNEXTLINE(bugprone-use-after-move): a second call must fail instead of returning zero keys
    QCOMPARE(std::move(initiator).finish().error(), NoiseError::Unfinished);
}

void HandshakeStateTest::doesNothingAfterAMove()
{
    Ends ends;
    HandshakeState initiator = ends.initiator();
    HandshakeState responder = ends.responder();
    HandshakeState movedInitiator = std::move(initiator);
    HandshakeState movedResponder = std::move(responder);
    Bytes out(200);
    // NOLINTBEGIN(bugprone-use-after-move): calls must fail instead of using the wiped keys
    QCOMPARE(initiator.writeMessage({}, out, ends.random).error(), NoiseError::OutOfTurn);
    const Bytes first = ends.first(movedInitiator);
    QCOMPARE(read(responder, first).error(), NoiseError::OutOfTurn);
    // NOLINTEND(bugprone-use-after-move)
    QVERIFY(read(movedResponder, first));
    QVERIFY(read(movedInitiator, ends.second(movedResponder)));
}

void HandshakeStateTest::limitsLengths()
{
    Ends ends;
    HandshakeState initiator = ends.initiator();
    HandshakeState responder = ends.responder();
    Bytes out(70000);
    QCOMPARE(initiator.writeMessage(Bytes(65535 - 95), out, ends.random).error(), NoiseError::TooLong);
    Bytes small(95);
    QCOMPARE(initiator.writeMessage({}, small, ends.random).error(), NoiseError::NoRoom);
    const Bytes largest = ends.first(initiator, Bytes(65535 - 96));
    QCOMPARE(largest.size(), std::size_t(65535));
    QCOMPARE(read(responder, Bytes(95)).error(), NoiseError::Truncated);
    Bytes tooLittle(largest.size() - 97);
    QCOMPARE(responder.readMessage(largest, tooLittle).error(), NoiseError::NoRoom);
    QCOMPARE(read(responder, Bytes(65536)).error(), NoiseError::TooLong);
    QVERIFY(read(responder, largest));

    QCOMPARE(responder.writeMessage(Bytes(65535 - 47), out, ends.random).error(), NoiseError::TooLong);
    QCOMPARE(responder.writeMessage({}, MutableByteView(small).first(47), ends.random).error(), NoiseError::NoRoom);
    QCOMPARE(read(initiator, Bytes(47)).error(), NoiseError::Truncated);
    QVERIFY(read(initiator, ends.second(responder, Bytes(65535 - 48))));
}

void HandshakeStateTest::cipherStateStopsBeforeTheLastNonce()
{
    CipherState cipher;
    Bytes out(16);
    QCOMPARE(cipher.encryptWithAd({}, {}, out).error(), NoiseError::MissingKey);
    QCOMPARE(cipher.decryptWithAd({}, out, out).error(), NoiseError::MissingKey);
    cipher.initializeKey(pskOf(1));
    cipher.setNonce(~std::uint64_t(0) - 1);
    QVERIFY(cipher.encryptWithAd({}, {}, out));
    QCOMPARE(cipher.encryptWithAd({}, {}, out).error(), NoiseError::NonceExhausted);
    QCOMPARE(cipher.decryptWithAd({}, out, out).error(), NoiseError::NonceExhausted);
    cipher.setNonce(0);
    QCOMPARE(cipher.decryptWithAd({}, Bytes(15), out).error(), NoiseError::Truncated);
    QCOMPARE(cipher.decryptWithAd({}, Bytes(16), out).error(), NoiseError::DecryptionFailed);
    QCOMPARE(cipher.encryptWithAd({}, Bytes(1), out).error(), NoiseError::NoRoom);
    QCOMPARE(cipher.decryptWithAd({}, Bytes(33), out).error(), NoiseError::NoRoom);
    QVERIFY(cipher.encryptWithAd({}, {}, out));
    CipherState fresh;
    fresh.initializeKey(pskOf(1));
    QVERIFY(fresh.decryptWithAd({}, out, {})); // failed calls use no nonce
}

SKYSEAL_TEST_APPLESS(HandshakeStateTest)
#include "handshake_state_test.moc"
