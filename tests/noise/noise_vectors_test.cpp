// The published vector of Noise_IKpsk2_25519_ChaChaPoly_BLAKE2b (cacophony's), byte for byte, both roles.
#include "core/crypto/init_crypto.h"
#include "core/noise/handshake_state.h"
#include "tests/support/test_runner.h"

#include "tests/crypto/vector_file.h"
#include "tests/noise/fixed_random.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::noise;

namespace {

Key32 keyFrom(const Bytes &bytes)
{
    return Key32(ByteView(bytes).first<32>());
}

} // namespace

class NoiseVectorsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void publishedHandshake();
};

void NoiseVectorsTest::publishedHandshake()
{
    const auto paragraphs = test::readVectors("noise_ikpsk2.txt");
    QCOMPARE(paragraphs.size(), std::size_t(7));
    const test::Vector &keys = paragraphs.front();
    const Bytes prologue = keys.bytes("prologue");
    auto initiatorsKeys = X25519KeyPair::fromSecret(keyFrom(keys.bytes("initiator_static")));
    auto respondersKeys = X25519KeyPair::fromSecret(keyFrom(keys.bytes("responder_static")));
    QCOMPARE(toHex(respondersKeys.publicKey), keys.text("responder_public"));
    auto initiator = HandshakeState::initiator(prologue, std::move(initiatorsKeys), respondersKeys.publicKey);
    auto responder = HandshakeState::responder(prologue, std::move(respondersKeys));
    initiator.setPsk(keyFrom(keys.bytes("psk")));
    responder.setPsk(keyFrom(keys.bytes("psk")));

    const auto exchange = [](HandshakeState &sender, HandshakeState &receiver, std::size_t overhead, const test::Vector &vector,
                             const Bytes &ephemeral) {
        test::FixedRandom random(ephemeral);
        const Bytes payload = vector.bytes("payload");
        Bytes message(payload.size() + overhead);
        QVERIFY(sender.writeMessage(payload, message, random));
        QCOMPARE(toHex(message), vector.text("ciphertext"));
        Bytes received(payload.size());
        QVERIFY(receiver.readMessage(message, received));
        QCOMPARE(received, payload);
    };
    exchange(initiator, responder, kFirstOverhead, paragraphs[1], keys.bytes("initiator_ephemeral"));
    exchange(responder, initiator, kSecondOverhead, paragraphs[2], keys.bytes("responder_ephemeral"));

    auto initiators = std::move(initiator).finish(), responders = std::move(responder).finish();
    QVERIFY(initiators && responders);
    QCOMPARE(toHex(initiators->handshakeHash), keys.text("handshake_hash"));
    QCOMPARE(toHex(responders->handshakeHash), keys.text("handshake_hash"));
    QVERIFY(initiators->receive.equals(responders->send) && responders->receive.equals(initiators->send));
    CipherState fromInitiator, fromResponder;
    fromInitiator.initializeKey(std::move(initiators->send));
    fromResponder.initializeKey(std::move(responders->send));
    for (std::size_t i = 3; i < paragraphs.size(); ++i) {
        const Bytes payload = paragraphs[i].bytes("payload");
        Bytes message(payload.size() + kTagLength);
        QVERIFY((i % 2 == 1 ? fromInitiator : fromResponder).encryptWithAd({}, payload, message));
        QCOMPARE(toHex(message), paragraphs[i].text("ciphertext"));
    }
}

SKYSEAL_TEST_APPLESS(NoiseVectorsTest)
#include "noise_vectors_test.moc"
