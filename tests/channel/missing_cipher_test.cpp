// A machine that lacks a cipher: OpenSSL's legacy provider, and RC4 with it, is not installed everywhere. Such a suite is
// neither offered nor accepted, and a cipher that fails nevertheless costs a switch and nothing else.
#include "core/channel/live_switch.h"
#include "core/crypto/init_crypto.h"
#include "pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;
using crypto::SuiteId;

namespace {

/// A session's part in its switch, on a machine on which no cipher can be made.
class NoCiphers final : public SwitchActions
{
public:
    Epoch currentEpoch() const override { return Epoch{0}; }
    SuiteId currentSuite() const override { return SuiteId::ChaCha20Poly1305; }
    bool permittedHere(SuiteId) const override { return true; }
    bool permittedByPeer(SuiteId) const override { return true; }
    bool previousDispensable(TimePoint) const override { return true; }
    Duration answerTime() const override { return 1ms; }
    crypto::PublicKey makeProposalKey() override { return {}; }
    void dropProposalKey() override {}
    void send(TimePoint, const ControlMessage &message) override { said.push_back(message); }
    NextEpoch answerProposal(TimePoint, const Propose &, crypto::PublicKey &) override { return NextEpoch::NoCipher; }
    NextEpoch takeAnswer(TimePoint, SuiteId, const crypto::PublicKey &) override { return NextEpoch::NoCipher; }
    void dropNext() override {}
    void commitNext(TimePoint) override { committed = true; }
    std::uint32_t sentBefore() const override { return 0; }
    void peerSentBefore(std::uint32_t) override {}
    void notify(const Event &event) override { events.push_back(event); }

    std::vector<ControlMessage> said;
    std::vector<Event> events;
    bool committed = false;
};

} // namespace

class MissingCipherTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        qputenv("OPENSSL_MODULES", "/nonexistent"); // before the first look for the provider
        QVERIFY(crypto::initCrypto());
        QVERIFY(!crypto::suiteAvailable(SuiteId::Rc4));
    }
    void isNotOffered();
    void answererRefuses();
    void proposerGivesUp();
};

void MissingCipherTest::isNotOffered()
{
    Pair pair; // both of whose policies list and allow all suites
    QVERIFY(pair.run(2s, [&] { return pair.bothUp(); }));
    pair.every(20ms, [&pair] { pair.sendFrame(Air); });
    for (const Side side : {Ground, Air}) {
        auto &end = pair.ends[side];
        const auto info = *end.sessionInfo();
        for (const auto &suites : {info.permitted, info.peerOffered}) {
            QCOMPARE(suites.size(), crypto::sealedSuites().size() - 1);
            QCOMPARE(std::count(suites.begin(), suites.end(), SuiteId::Rc4), 0);
        }
        end.switchSuite(pair.now, SuiteId::Rc4);
        pair.run(1s);
        const auto done = end.all<SwitchDone>();
        QCOMPARE(done.size(), 1u);
        QCOMPARE(done[0].failure, SwitchFailure::NotAllowedHere);
        QCOMPARE(end.sessionInfo()->suite, SuiteId::ChaCha20Poly1305);
        end.events.clear();
    }
    // A new policy does not change this.
    pair.air().setPolicy(pair.now, pair.air().policy);
    const auto permitted = pair.air().sessionInfo()->permitted;
    QCOMPARE(std::count(permitted.begin(), permitted.end(), SuiteId::Rc4), 0);
    pair.stopTraffic();
    pair.run(1s);
    QVERIFY(pair.bothUp());
    QCOMPARE(QString::fromStdString(pair.accountFrom(Air)), QString());
}

void MissingCipherTest::answererRefuses()
{
    NoCiphers actions;
    LiveSwitch agents(SessionId{1}, false, Timing());
    const Propose proposal{ProposalId{1}, Epoch{1}, SuiteId::Aes256Gcm, {}};
    for (int copy = 0; copy < 2; ++copy)
        agents.handle(TimePoint(1h), proposal, actions);
    QCOMPARE(actions.said.size(), 2u);
    for (const ControlMessage &message : actions.said)
        QVERIFY(std::holds_alternative<Refuse>(message) && std::get<Refuse>(message).id == proposal.id);
    QVERIFY(actions.events.empty());
    QVERIFY(!agents.pending());
}

void MissingCipherTest::proposerGivesUp()
{
    NoCiphers actions;
    LiveSwitch stations(SessionId{1}, true, Timing());
    stations.request(TimePoint(1h), SuiteId::Aes256Gcm, false, actions);
    QVERIFY(std::holds_alternative<Propose>(actions.said.at(0)));
    stations.handle(TimePoint(1h), Accept{std::get<Propose>(actions.said[0]).id, {}}, actions);
    QVERIFY(!actions.committed);
    QVERIFY(!stations.pending());
    QCOMPARE(actions.events.size(), 2u);
    QVERIFY(std::holds_alternative<SwitchDone>(actions.events[1]));
    QCOMPARE(std::get<SwitchDone>(actions.events[1]).failure, SwitchFailure::NotAllowedHere);
}

SKYSEAL_TEST(MissingCipherTest)
#include "missing_cipher_test.moc"
