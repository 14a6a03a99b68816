// Every published vector of 25519, ChaChaPoly and BLAKE2b (cacophony's), byte for byte, both roles.
#include "core/crypto/init_crypto.h"
#include "core/noise/handshake_state.h"
#include "tests/support/test_runner.h"

#include "tests/crypto/external_vectors.h"
#include "tests/noise/fixed_random.h"

#include <QtCore/QJsonArray>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::noise;
using test::hexField;

namespace {

/// One side of a vector: the handshake, then the transport ciphers.
struct Side
{
    std::optional<HandshakeState> handshake; ///< until it is complete
    test::FixedRandom random;
    CipherState send;
    CipherState receive;
};

Key32 keyFrom(const Bytes &bytes)
{
    return bytes.size() == 32 ? Key32(ByteView(bytes).first<32>()) : Key32();
}

Side makeSide(const QJsonObject &vector, Party role)
{
    const std::string prefix = role == Party::Initiator ? "init_" : "resp_";
    const auto field = [&](const char *name) { return hexField(vector, (prefix + name).c_str()); };
    const Bytes prologue = field("prologue");
    const std::string protocol = vector.value(QLatin1String("protocol_name")).toString().toStdString();
    const std::string pattern = protocol.substr(6, protocol.find('_', 6) - 6);

    HandshakeConfig config{role, pattern, prologue, {}, {}, {}};
    if (const Bytes secret = field("static"); !secret.empty())
        config.localStatic = X25519KeyPair::fromSecret(keyFrom(secret));
    if (const Bytes remote = field("remote_static"); remote.size() == 32) {
        config.remoteStatic.emplace();
        std::copy(remote.begin(), remote.end(), config.remoteStatic->begin());
    }
    for (const QJsonValue &psk : vector.value(QLatin1String((prefix + "psks").c_str())).toArray())
        config.psks.push_back(keyFrom(*fromHex(psk.toString().toStdString())));
    auto handshake = HandshakeState::initialize(std::move(config));
    if (!handshake)
        qFatal("%s: %d", protocol.c_str(), int(handshake.error()));
    return {std::move(*handshake), test::FixedRandom(field("ephemeral")), {}, {}};
}

/// Sends `payload` in the handshake or, once it is complete, with the transport ciphers.
Bytes sendBytes(Side &side, const Bytes &payload)
{
    Bytes out(payload.size() + 256);
    const auto written = side.handshake ? side.handshake->writeMessage(payload, out, side.random)
                                        : side.send.encryptWithAd({}, payload, out);
    out.resize(written.value_or(0));
    return out;
}

Bytes receiveBytes(Side &side, const Bytes &message)
{
    Bytes out(message.size());
    const auto read = side.handshake ? side.handshake->readMessage(message, out) : side.receive.decryptWithAd({}, message, out);
    out.resize(read.value_or(0));
    return out;
}

} // namespace

class NoiseVectorsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void publishedHandshakes_data();
    void publishedHandshakes();
};

void NoiseVectorsTest::publishedHandshakes_data()
{
    QTest::addColumn<QJsonObject>("vector");
    const auto file = test::externalVectors("noise_25519_chachapoly_blake2b.json");
    if (!file) {
        QTest::newRow("none") << QJsonObject();
        return;
    }
    const QJsonArray vectors = file->value(QLatin1String("vectors")).toArray();
    QVERIFY(vectors.size() > 50);
    for (const QJsonValue &vector : vectors)
        QTest::newRow(qPrintable(vector.toObject().value(QLatin1String("protocol_name")).toString())) << vector.toObject();
}

void NoiseVectorsTest::publishedHandshakes()
{
    QFETCH(QJsonObject, vector);
    if (vector.isEmpty())
        QSKIP(test::externalVectorsMissing());

    Side initiator = makeSide(vector, Party::Initiator);
    Side responder = makeSide(vector, Party::Responder);
    const QString protocol = vector.value(QLatin1String("protocol_name")).toString();
    const std::string pattern = protocol.section(QLatin1Char('_'), 1, 1).toStdString();
    const bool oneWay = handshakePattern(pattern)->messages.size() == 1;
    bool fromInitiator = true;
    bool split = false;
    for (const QJsonValue &value : vector.value(QLatin1String("messages")).toArray()) {
        Side &sender = fromInitiator ? initiator : responder;
        Side &receiver = fromInitiator ? responder : initiator;
        const Bytes payload = hexField(value.toObject(), "payload");
        const std::size_t overhead = sender.handshake ? sender.handshake->nextOverhead() : kTagLength;
        const Bytes message = sendBytes(sender, payload);
        QCOMPARE(toHex(message), toHex(hexField(value.toObject(), "ciphertext")));
        QCOMPARE(message.size(), payload.size() + overhead);
        QCOMPARE(toHex(receiveBytes(receiver, message)), toHex(payload));
        if (sender.handshake && sender.handshake->isComplete()) {
            for (Side *side : {&initiator, &responder}) {
                QVERIFY(side->handshake->isComplete());
                auto secrets = (*std::exchange(side->handshake, std::nullopt)).finish();
                QVERIFY(secrets.has_value());
                QCOMPARE(toHex(secrets->handshakeHash), toHex(hexField(vector, "handshake_hash")));
                side->send.initializeKey(std::move(secrets->send));
                side->receive.initializeKey(std::move(secrets->receive));
            }
            split = true;
        }
        fromInitiator = oneWay || !fromInitiator;
    }
    QVERIFY(split);
}

SKYSEAL_TEST_APPLESS(NoiseVectorsTest)
#include "noise_vectors_test.moc"
