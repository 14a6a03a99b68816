// The known answers of PROTOCOL.md against this implementation. They are read from the document, so that it cannot differ
// from the programs. An independent implementation checks the same ones (tests/integration/independent_peer).
#include "core/base/secret_bytes.h"
#include "core/channel/cobs.h"
#include "core/channel/cookie.h"
#include "core/channel/epoch_exchange.h"
#include "core/channel/frame_stamp.h"
#include "core/channel/handshake.h"
#include "core/channel/inline_frame.h"
#include "core/channel/pairing_handshake.h"
#include "core/channel/record.h"
#include "core/channel/suite_list.h"
#include "core/channel/pairing_messages.h"
#include "core/channel/tunnel_parts.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/kdf.h"
#include "core/crypto/passphrase.h"
#include "core/crypto/record_cipher.h"
#include "core/engine/common/dialect_traits.h"
#include "core/keys/public_key_text.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "known_answers.h"
#include "tests/noise/fixed_random.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::channel;
using namespace skyseal::test;
using crypto::SuiteId;
using crypto::X25519KeyPair;

namespace {

template<typename Range> Bytes bytesOf(const Range &range)
{
    return Bytes(range.begin(), range.end());
}

template<std::size_t N> std::array<std::uint8_t, N> arrayOf(const Bytes &bytes)
{
    std::array<std::uint8_t, N> out{};
    std::copy_n(bytes.begin(), std::min(bytes.size(), N), out.begin());
    return out;
}

Key32 secretOf(const Bytes &bytes)
{
    return Key32(arrayOf<32>(bytes));
}

Peer known(const PublicKey &key, const Bytes &psk)
{
    return {key, "known", {}, {}, std::make_shared<const Key32>(secretOf(psk))};
}

constexpr ConnectionId kStations{0x1234};
constexpr ConnectionId kAgents{0xabcd};
constexpr std::uint32_t kCounter = 0x010203;

/// A record as the station seals it, without a connection id on a line.
Bytes sealedByStation(SuiteId suite, Key32 &&secret, std::uint8_t epochBits, std::uint32_t counter, ByteView plaintext,
                      Carrier carrier = Carrier::Datagram)
{
    const auto cipher = crypto::makeRecordCipher(suite, std::move(secret));
    const auto kind = carrier == Carrier::Serial ? DatagramKind::SingleRecord : DatagramKind::Record;
    const RecordHeader header{kind, epochBits, kAgents, counter};
    Bytes out(header.length() + cipher->sealedSize(plaintext.size()));
    header.write(out);
    const AssociatedData associated(ByteView(out).first(header.length()), suite, Direction::FromInitiator, carrier);
    cipher->seal(counter, associated.view(), plaintext, MutableByteView(out).subspan(header.length()));
    return out;
}

} // namespace

/// Compares with the example of this name, which the document must have.
#define COMPARE_WITH(name, actual)                                                                                             \
    do {                                                                                                                       \
        QVERIFY2(!m_answers[name].empty(), name);                                                                              \
        QCOMPARE(QByteArray(toByteArray(actual).toHex()), toByteArray(m_answers[name]).toHex());                               \
    } while (false)

class KnownAnswersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void keys();
    void announcement();
    void handshake();
    void transportKeys();
    void cookie();
    void number();
    void epochs();
    void records_data();
    void records();
    void carriers();
    void inlineFrames_data();
    void inlineFrames();
    void controlMessages();
    void stampedFrame();
    void pairing();
    void cleanupTestCase();

private:
    template<typename Range> static QByteArray toByteArray(const Range &range)
    {
        return QByteArray(reinterpret_cast<const char *>(range.data()), static_cast<qsizetype>(range.size()));
    }
    X25519KeyPair pair(const char *name) const { return X25519KeyPair::fromSecret(secretOf(m_answers[name])); }

    KnownAnswers m_answers = KnownAnswers::read(SKYSEAL_SOURCE_DIR "/core/channel/PROTOCOL.md");
    X25519KeyPair m_station, m_agent;
    const engine::DialectTraits m_facts{mavlink::Dialect::builtin()};
    const SuiteOffer m_stationsOffer{{SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm, SuiteId::Aes256Ctr, SuiteId::Aes256Cbc,
                                      SuiteId::ChaCha20, SuiteId::Rc4},
                                     true};
    const SuiteOffer m_agentsOffer{{SuiteId::Aes256Ctr, SuiteId::Aes256Gcm}};
};

void KnownAnswersTest::initTestCase()
{
    QVERIFY(crypto::initCrypto());
    QVERIFY2(m_answers.problem().empty(), m_answers.problem().c_str());
    m_station = pair("station private");
    m_agent = pair("agent private");
}

void KnownAnswersTest::keys()
{
    COMPARE_WITH("station public", m_station.publicKey);
    COMPARE_WITH("agent public", m_agent.publicKey);
    COMPARE_WITH("agent public as text", keys::publicKeyText(m_agent.publicKey));
    COMPARE_WITH("agent fingerprint", keys::fingerprint(m_agent.publicKey));
}

void KnownAnswersTest::announcement()
{
    FixedRandom nonce(m_answers["announcement nonce"]);
    const Announcement announcement(m_agent.publicKey);
    COMPARE_WITH("announcement", announcement.make(nonce));
    QVERIFY(announcement.recognises(m_answers["announcement"]));
}

void KnownAnswersTest::handshake()
{
    COMPARE_WITH("suite list", packSuiteNumbers(Bytes{2, 200, 1, 15}));
    const FirstPayload first{kStations, m_stationsOffer, 7};
    COMPARE_WITH("first payload", first.write());
    const AnswerPayload answer{kAgents, m_agentsOffer, SuiteId::Aes256Gcm};
    COMPARE_WITH("answer payload", answer.write());

    const Bytes psk = m_answers["pre-shared key"];
    FixedRandom stationsEphemeral(m_answers["station ephemeral private"]);
    FixedRandom agentsEphemeral(m_answers["agent ephemeral private"]);
    auto initiator = Initiator::begin(m_station, known(m_agent.publicKey, psk), first, stationsEphemeral);
    QVERIFY(initiator);
    COMPARE_WITH("first message", initiator->message());
    auto responder = Responder::read(m_agent, m_answers["first message"]);
    QVERIFY(responder);
    const auto answered =
        std::move(*responder).answer(known(m_station.publicKey, psk), kAgents, m_agentsOffer, agentsEphemeral);
    QVERIFY(answered);
    COMPARE_WITH("answer", answered->message);
    const auto agreement = initiator->readAnswer(m_answers["answer"]);
    QVERIFY(agreement);
    QCOMPARE(agreement->suite, SuiteId::Aes256Gcm);
    const EpochSecrets zero = agreement->chain.begin(SuiteId::Aes256Gcm);
    COMPARE_WITH("station(0)", zero.fromInitiator.view());
    COMPARE_WITH("agent(0)", zero.fromResponder.view());
}

void KnownAnswersTest::transportKeys()
{
    const std::string prologue("skyseal channel v1\x01");
    FixedRandom stationsEphemeral(m_answers["station ephemeral private"]);
    auto noise = noise::HandshakeState::initiator(asBytes(prologue), m_station.clone(), m_agent.publicKey);
    noise.setPsk(secretOf(m_answers["pre-shared key"]));
    Bytes first(kFirstLength - 1 - kMacLength);
    QVERIFY(noise.writeMessage(m_answers["first payload"], first, stationsEphemeral));
    Bytes payload(AnswerPayload::kLength);
    const Bytes answer = m_answers["answer"];
    QVERIFY(noise.readMessage(ByteView(answer).subspan(3, kAnswerLength - 3 - kMacLength), payload));
    COMPARE_WITH("answer payload", payload);
    const auto secrets = std::move(noise).finish();
    QVERIFY(secrets);
    COMPARE_WITH("handshake hash", secrets->handshakeHash);
    COMPARE_WITH("k1", secrets->send.view());
    COMPARE_WITH("k2", secrets->receive.view());
}

void KnownAnswersTest::cookie()
{
    const Bytes &first = m_answers["first message"];
    const auto opened = openCookie(m_agent.publicKey, ByteView(first).last(kMacLength), m_answers["cookie message"]);
    QVERIFY(opened);
    COMPARE_WITH("cookie", *opened);
    COMPARE_WITH("cookie nonce", ByteView(m_answers["cookie message"]).subspan(1, 16));
    Bytes under = first;
    signWithCookie(*opened, under);
    COMPARE_WITH("first message under the cookie", under);
}

void KnownAnswersTest::number()
{
    const Bytes psk = m_answers["pre-shared key"];
    FixedRandom stationsEphemeral(m_answers["station ephemeral private"]);
    FixedRandom agentsEphemeral(m_answers["agent ephemeral private"]);
    auto responder = Responder::read(m_agent, m_answers["first message"]);
    QVERIFY(responder);
    const auto number = std::move(*responder).writeNumber(known(m_station.publicKey, psk), 41, agentsEphemeral);
    QVERIFY(number);
    COMPARE_WITH("number", *number);
    auto initiator = Initiator::begin(m_station, known(m_agent.publicKey, psk), {kStations, m_stationsOffer, 7},
                                      stationsEphemeral);
    QVERIFY(initiator);
    QCOMPARE(initiator->readNumber(m_answers["number"]), std::optional<std::uint64_t>(41));
}

void KnownAnswersTest::epochs()
{
    const KeyChain chain(secretOf(m_answers["k1"]), secretOf(m_answers["k2"]), m_answers["handshake hash"]);
    EpochSecrets zero = chain.begin(SuiteId::Aes256Gcm);
    COMPARE_WITH("station(0)", zero.fromInitiator.view());
    COMPARE_WITH("agent(0)", zero.fromResponder.view());
    EpochExchange proposer;
    FixedRandom proposals(m_answers["proposal private"]), answers(m_answers["answer private"]);
    COMPARE_WITH("proposal public", proposer.propose(proposals));
    const auto answered = EpochExchange::answer(arrayOf<32>(m_answers["proposal public"]), answers);
    COMPARE_WITH("answer public", answered->answerer);
    const auto finished = proposer.finish(answered->answerer);
    COMPARE_WITH("dh(1)", answered->shared.view());
    COMPARE_WITH("dh(1)", finished->shared.view());
    const EpochSecrets one = zero.next.advance(Epoch{1}, SuiteId::Aes256Ctr, *finished);
    COMPARE_WITH("station(1)", one.fromInitiator.view());
    COMPARE_WITH("agent(1)", one.fromResponder.view());

    // The chain itself is private to its class; what it must be follows from the formulas.
    const Bytes k1k2 = [&] {
        Bytes both = m_answers["k1"];
        both.insert(both.end(), m_answers["k2"].begin(), m_answers["k2"].end());
        return both;
    }();
    COMPARE_WITH("chain(0)", crypto::hkdfExtractSha256(m_answers["handshake hash"], k1k2).view());
    Bytes next = bytesOf(std::string_view("skyseal v1 epoch next"));
    next.resize(next.size() + 4 + 1 + 64);
    next[next.size() - 65] = 2;
    COMPARE_WITH("next(0)", crypto::hkdfExpandKey(secretOf(m_answers["chain(0)"]), next).view());
    COMPARE_WITH("chain(1)", crypto::hkdfExtractSha256(m_answers["next(0)"], m_answers["dh(1)"]).view());

    COMPARE_WITH("record of the session",
                 sealedByStation(SuiteId::Aes256Gcm, std::move(zero.fromInitiator), 0, 0, m_answers["frame"]));
}

void KnownAnswersTest::records_data()
{
    QTest::addColumn<int>("number");
    for (const crypto::SuiteInfo &suite : crypto::suites()) {
        if (suite.id != SuiteId::None)
            QTest::newRow(std::string(suite.name).c_str()) << static_cast<int>(suite.id);
    }
}

void KnownAnswersTest::records()
{
    QFETCH(int, number);
    const auto suite = static_cast<SuiteId>(number);
    const std::string name(crypto::suiteInfo(suite).name);
    COMPARE_WITH((name + " record").c_str(),
                 sealedByStation(suite, secretOf(m_answers["direction secret"]), 5, kCounter, m_answers["frame"]));

    Bytes record = m_answers[name + " record"];
    const AssociatedData associated(ByteView(record).first(kRecordHeaderLength), suite, Direction::FromInitiator,
                                    Carrier::Datagram);
    const auto cipher = crypto::makeRecordCipher(suite, secretOf(m_answers["direction secret"]));
    const auto opened = cipher->open(kCounter, associated.view(), MutableByteView(record).subspan(kRecordHeaderLength));
    QVERIFY(opened);
    COMPARE_WITH("frame", *opened);

    for (const char *use : {"key", "iv", "mac"}) {
        const Bytes &key = m_answers[name + ' ' + use];
        if (key.empty())
            continue;
        Bytes expanded(key.size());
        const std::string info = "skyseal v1 record " + name + ' ' + use;
        QVERIFY(crypto::hkdfExpandSha256(expanded, m_answers["direction secret"], asBytes(info)));
        QCOMPARE(expanded, key);
    }
}

void KnownAnswersTest::carriers()
{
    const auto sealed = [this](Carrier carrier) {
        return sealedByStation(SuiteId::ChaCha20Poly1305, secretOf(m_answers["direction secret"]), 5, kCounter,
                               m_answers["frame"], carrier);
    };
    const auto cobs = [](ByteView message) {
        Bytes out(kMaxCobs);
        out.resize(writeCobs(message, out));
        return out;
    };
    const auto tunnelled = [](ByteView message, Node from, Node to) {
        mavlink::Tunnel tunnel;
        tunnel.target_system = to.system;
        tunnel.target_component = to.component;
        tunnel.payload_type = kTunnelPayloadType;
        tunnel.payload_length = static_cast<std::uint8_t>(message.size());
        std::copy(message.begin(), message.end(), tunnel.payload.begin());
        if (isPadded(message))
            tunnel.payload.back() = kTunnelPadding;
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        return bytesOf(mavlink::FrameWriter(from.system, from.component).write(tunnel, buffer));
    };
    COMPARE_WITH("serial record", sealed(Carrier::Serial));
    COMPARE_WITH("serial frame", cobs(m_answers["serial record"]));
    COMPARE_WITH("serial announcement", cobs(m_answers["announcement"]));

    COMPARE_WITH("tunnel record", sealed(Carrier::Tunnel));
    COMPARE_WITH("tunnel frame", tunnelled(m_answers["tunnel record"], {255, 190}, {1, 191}));
    COMPARE_WITH("tunnel request", tunnelled(pairingRequest(), {255, 190}, {0, 0}));

    Bytes message = m_answers["first message"];
    message.insert(message.end(), m_answers["answer"].begin(), m_answers["answer"].end());
    std::vector<Bytes> parts;
    QVERIFY(writeParts(message, 0x0102, [&](ByteView part) { parts.push_back(bytesOf(part)); }));
    QCOMPARE(parts.size(), std::size_t(2));
    COMPARE_WITH("tunnel part 0", parts[0]);
    COMPARE_WITH("tunnel part 1", parts[1]);
}

void KnownAnswersTest::inlineFrames_data()
{
    QTest::addColumn<int>("number");
    for (const crypto::SuiteInfo &suite : crypto::suites()) {
        if (suite.makeInline)
            QTest::newRow(std::string(suite.name).c_str()) << static_cast<int>(suite.id);
    }
}

void KnownAnswersTest::inlineFrames()
{
    QFETCH(int, number);
    const auto suite = static_cast<SuiteId>(number);
    const InlinePlace place{1, 5, Direction::FromInitiator, Carrier::Datagram};
    const auto cipher = crypto::makeInlineCipher(suite, secretOf(m_answers["inline secret"]));
    for (const std::string plain : {"command", "frame"}) {
        const std::string name = std::string(crypto::suiteInfo(suite).name) + " inline " + plain;
        const auto sealable = SealableFrame::read(m_answers[plain], m_facts);
        QVERIFY(sealable);
        Bytes sealed(sealable->sealedSize());
        QVERIFY(sealable->seal(place, *cipher, sealed));
        COMPARE_WITH(name.c_str(), sealed);
        const auto read = InlineFrame::read(sealed, m_facts);
        QVERIFY(read);
        QCOMPARE(read->counter(), place.counter);
        const auto opened = read->open(place.direction, place.carrier, *cipher);
        QVERIFY(opened);
        COMPARE_WITH(plain.c_str(), *opened);
    }
}

void KnownAnswersTest::stampedFrame()
{
    const Bytes frame = m_answers["frame"];
    Bytes plaintext(kFrameStampLength + frame.size());
    stampFrames(123456789, frame, plaintext);
    COMPARE_WITH("stamped frame", plaintext);
    QCOMPARE(frameStamp(plaintext), std::optional<std::uint32_t>(123456789 & ~1023u));
    QVERIFY(std::equal(frame.begin(), frame.end(), plaintext.begin() + kFrameStampLength));
}

void KnownAnswersTest::controlMessages()
{
    const auto key = [this](const char *name) { return arrayOf<32>(m_answers[name]); };
    Report report;
    report.answerAtOnce = true;
    report.stamp = 1000001;
    report.echo = 999001;
    report.held = 250;
    report.rx = {.good = 1000,
                 .late = 3,
                 .lost = 2,
                 .replayed = 1,
                 .forged = 0,
                 .malformed = 0,
                 .plaintextDropped = 0,
                 .openedBytes = 30000};
    report.tx = {.records = 40, .sealedBytes = 2000};
    Report costly = report;
    costly.answerAtOnce = false;
    costly.asksCosts = true;
    costly.frames = {.taken = 900, .lost = 1};
    costly.costs = {.cpuMicroseconds = 2500000,
                    .residentBytes = 14680064,
                    .opened = 40,
                    .openNanoseconds = 60000,
                    .sealed = 1000,
                    .sealNanoseconds = 1500000};
    Report late = report;
    late.answerAtOnce = false;
    late.freshness = {.stale = 4, .ageMicroseconds = 2400000, .overtakenMilliseconds = 1000, .limitMilliseconds = 5000};
    Report unstored = late;
    unstored.cannotStore = true;
    Report deaf = late;
    deaf.receivesNothing = true;
    const std::pair<const char *, ControlMessage> messages[] = {
        {"propose", Propose{ProposalId{1}, Epoch{1}, SuiteId::Aes256Ctr, key("proposal public")}},
        {"accept", Accept{ProposalId{1}, key("answer public")}},
        {"refuse", Refuse{ProposalId{1}}},
        {"confirm", Confirm{Epoch{1}, 300}},
        {"confirmed", Confirmed{Epoch{1}, 1000}},
        {"report", report},
        {"report with costs", costly},
        {"report of an agent", late},
        {"report of an agent that cannot store", unstored},
        {"report of an agent that hears nothing", deaf},
        {"close", Close{}},
    };
    for (const auto &[name, message] : messages) {
        Bytes out(kMaxControl);
        out.resize(writeControl(message, out));
        COMPARE_WITH(name, out);
        const auto again = readControl(m_answers[name]);
        QVERIFY2(again && again->index() == message.index(), name);
        Bytes rewritten(kMaxControl);
        rewritten.resize(writeControl(*again, rewritten));
        COMPARE_WITH(name, rewritten);
    }
}

void KnownAnswersTest::pairing()
{
    const auto token = arrayOf<16>(m_answers["pairing token"]);
    const auto handshakeOf = [&](Role role, const X25519KeyPair &identity, const std::string &name, std::uint8_t systemId,
                                 const std::string &who) {
        PairingConfig config;
        config.role = role;
        config.identity = std::make_shared<const X25519KeyPair>(identity.clone());
        config.name = name;
        config.systemId = systemId;
        config.passphrase = std::make_shared<const crypto::Passphrase>(
            *crypto::Passphrase::fromBytes(m_answers["pairing passphrase"]));
        Bytes drawn = m_answers["pairing nonce of the " + who];
        const Bytes scalar = m_answers["pairing scalar of the " + who];
        drawn.insert(drawn.end(), scalar.begin(), scalar.end());
        FixedRandom random(drawn);
        return PairingHandshake::begin(config, PairingId{0x01020304}, token, Carrier::Datagram, random);
    };
    COMPARE_WITH("pairing call", pairingCall(token));
    auto station = handshakeOf(Role::Station, m_station, "ground", 255, "station");
    auto agent = handshakeOf(Role::Agent, m_agent, "air-1", 1, "agent");
    COMPARE_WITH("pairing first", station.first());
    QVERIFY(agent.takeFirst(station.first()));
    COMPARE_WITH("pairing answer", agent.answer());
    QVERIFY(station.takeAnswer(agent.answer()));
    COMPARE_WITH("pairing opening of the station", station.opening());
    QVERIFY(agent.takeOpening(station.opening()));
    COMPARE_WITH("pairing opening of the agent", agent.opening());
    QVERIFY(station.takeOpening(agent.opening()));
    COMPARE_WITH("pairing code", station.code());
    COMPARE_WITH("pairing code", agent.code());

    auto stations = std::move(station).finish();
    auto agents = std::move(agent).finish();
    QVERIFY(stations && agents);
    COMPARE_WITH("pairing pre-shared key", stations->presharedKey()->view());
    COMPARE_WITH("pairing word of the station", stations->seal({Decision::Yes, Heard::Nothing}));
    COMPARE_WITH("pairing word of the agent", agents->seal({Decision::None, Heard::Yes}));
    QVERIFY(agents->open(m_answers["pairing word of the station"]));
}

void KnownAnswersTest::cleanupTestCase()
{
    // Run whole, nothing in the document goes unchecked.
    if (QCoreApplication::arguments().size() > 1)
        return;
    std::string names;
    for (const std::string &name : m_answers.unused())
        names += name + ", ";
    QVERIFY2(names.empty(), names.c_str());
}

SKYSEAL_TEST(KnownAnswersTest)
#include "known_answers_test.moc"
