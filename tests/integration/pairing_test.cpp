// Pairing between real programs over loopback: both users confirm the same code and a sealed session follows; a man in the
// middle has other fingerprints and gets nothing; the pairing window opens while the vehicle is disarmed, and closes when it is
// armed or the user leaves.
#include "core/channel/pairing.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/x25519.h"
#include "core/link/steady_now.h"
#include "tests/crypto/seeded_random.h"
#include "tests/support/eventually.h"
#include "tests/support/flight.h"
#include "tests/support/clear_frames.h"
#include "tests/support/heartbeat.h"
#include "tests/support/pairing_people.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

namespace {

QString text(const QJsonObject &event, const char *key)
{
    return event[QLatin1String(key)].toString();
}

/// A station that claims any system id, and confirms each agent that it is shown.
class ClaimingStation : public QObject
{
public:
    ClaimingStation(quint16 port, std::uint8_t systemId)
    {
        m_isBound = m_socket.bind(QHostAddress::LocalHost, port);
        channel::PairingConfig config;
        config.identity = std::make_shared<crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(m_random));
        config.name = "claimer";
        config.systemId = systemId;
        m_pairing.emplace(std::move(config), m_random, now());
        m_timer.callOnTimeout(this, [this] { work(); });
        m_timer.start(10);
    }
    bool isBound() const { return m_isBound; }

private:
    static TimePoint now() { return steadyNow(); }
    void work()
    {
        while (m_socket.hasPendingDatagrams()) {
            QByteArray bytes(m_socket.pendingDatagramSize(), 0);
            m_socket.readDatagram(bytes.data(), bytes.size(), &m_agent, &m_port);
            m_pairing->handleDatagram(now(), kPath, viewOf(bytes));
        }
        m_pairing->handleDeadline(now());
        if (m_pairing->peer() && !m_pairing->confirmedHere())
            m_pairing->confirm(now(), m_pairing->peer()->key);
        while (const auto out = m_pairing->pollTransmit())
            m_socket.writeDatagram(reinterpret_cast<const char *>(out->bytes.data()), static_cast<qint64>(out->bytes.size()),
                                   m_agent, m_port);
    }

    static constexpr Path kPath{LinkId{1}, {}};
    SeededRandom m_random{1};
    std::optional<channel::Pairing> m_pairing;
    QUdpSocket m_socket;
    QHostAddress m_agent;
    quint16 m_port = 0;
    bool m_isBound = false;
    QTimer m_timer;
};

} // namespace

class PairingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void init();
    void bothConfirmAndASessionFollows();
    void expectedFingerprintsNeedNoPerson();
    void oneNoIsEnough();
    void somebodyInBetweenGetsNothing();
    void changedKeyIsReplacedKnowingly();
    void expectedButChangedKeyIsRefused();
    void observerIsKeptAsOne();
    void knownRoleStays();
    void idsOfOtherStationsAreNotTaken();
    void vehiclesIdIsNotBound();
    void armedVehicleOpensNoWindow();
    void armingClosesTheWindow();
    void leavingClosesTheWindow();
    void nobodyToAnswerIsTold();
    void oneVisitorAtATime();
    void passphraseOfBothEnds();
    void wrongPassphraseIsTold();
    void passphraseAtOneEndIsTold();

private:
    QString path(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    QByteArray read(const char *name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QString newKey(const char *name) const;
    std::unique_ptr<Program> agent(const char *key, const char *peers, quint16 ground) const;
    std::unique_ptr<Program> window(const char *key, const QStringList &more = {}) const;
    std::unique_ptr<Program> station(const char *key, const char *peers, quint16 port, const QStringList &more = {}) const;
    QString passphraseFile(const char *name, const QByteArray &words) const;
    static QStringList expecting(const QString &fingerprint) { return {QStringLiteral("--expect"), fingerprint}; }
    void sendHeartbeats(Program &until, const char *event, const Program::Predicate &predicate, bool armed);

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_ground, m_air; ///< fingerprints
    quint16 m_port = 0, m_vehiclePort = 0;
};

QString PairingTest::newKey(const char *name) const
{
    Program made(
        QStringLiteral("skyseal-cli"),
        {QStringLiteral("keys"), QStringLiteral("new"), QStringLiteral("--out"), path(name), QStringLiteral("--json")});
    return text(made.waitFor(QStringLiteral("key")), "fingerprint");
}

void PairingTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_ground = newKey("ground.key");
    m_air = newKey("air.key");
    QVERIFY(!m_ground.isEmpty() && !m_air.isEmpty());
    for (const char *peers : {"ground.peers", "air.peers", "mallory.peers"}) {
        QFile file(path(peers));
        QVERIFY(file.open(QIODevice::WriteOnly));
    }
    m_port = freeUdpPort();
    m_vehiclePort = freeUdpPort();
}

std::unique_ptr<Program> PairingTest::agent(const char *key, const char *peers, quint16 ground) const
{
    auto air = std::make_unique<Program>(
        QStringLiteral("skyseal-air"),
        QStringList{QStringLiteral("--vehicle"), QStringLiteral("udpin:127.0.0.1:%1").arg(m_vehiclePort),
                    QStringLiteral("--ground"), QStringLiteral("udpout:127.0.0.1:%1").arg(ground), QStringLiteral("--identity"),
                    path(key), QStringLiteral("--peers"), path(peers), QStringLiteral("--json")});
    const bool up = !air->waitFor(QStringLiteral("link")).isEmpty();
    return up ? std::move(air) : nullptr;
}

std::unique_ptr<Program> PairingTest::window(const char *key, const QStringList &more) const
{
    return std::make_unique<Program>(
        QStringLiteral("skyseal-air"),
        QStringList{QStringLiteral("--pair"), QStringLiteral("--identity"), path(key), QStringLiteral("--json")} + more);
}

std::unique_ptr<Program> PairingTest::station(const char *key, const char *peers, quint16 port, const QStringList &more) const
{
    return std::make_unique<Program>(QStringLiteral("skyseal-cli"),
                                     QStringList{QStringLiteral("keys"), QStringLiteral("pair"), QStringLiteral("--link"),
                                                 QStringLiteral("udpin:127.0.0.1:%1").arg(port), QStringLiteral("--identity"),
                                                 path(key), QStringLiteral("--peers"), path(peers), QStringLiteral("--json")}
                                         + more);
}

void PairingTest::bothConfirmAndASessionFollows()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto ground = station("ground.key", "ground.peers", m_port, {QStringLiteral("--as"), QStringLiteral("heron")});
    const auto desk = window("air.key", {QStringLiteral("--as"), QStringLiteral("base")});
    const QJsonObject open = desk->waitFor(QStringLiteral("pairing"), stateIs("open"));
    QCOMPARE(text(open, "fingerprint"), m_air);
    QCOMPARE(open[QLatin1String("seconds")].toInt(), 120);
    const QJsonObject shownThere = desk->waitFor(QStringLiteral("pairing"), stateIs("seen"));
    const QJsonObject shownHere = ground->waitFor(QStringLiteral("pairing"), stateIs("seen"));
    QCOMPARE(text(shownThere, "fingerprint"), m_ground);
    QCOMPARE(text(shownHere, "fingerprint"), m_air);
    QCOMPARE(text(shownHere, "code"), text(shownThere, "code"));
    QCOMPARE(text(shownHere, "code").size(), 7);
    QCOMPARE(shownThere[QLatin1String("system")].toInt(), 255);
    for (Program *program : {ground.get(), desk.get()}) {
        const QByteArray codeLine = "shows:\n    " + text(shownHere, "code").toUtf8() + '\n';
        EVENTUALLY2(program->errors().contains(codeLine), program->errors().constData());
        QVERIFY2(!program->errors().contains(":?"), program->errors().constData()); // a line break made printable
    }
    QVERIFY(!ground->errors().contains(m_air.toUtf8())); // only with --fingerprints
    QVERIFY(read("ground.peers").isEmpty() && read("air.peers").isEmpty());

    ground->notify(QStringLiteral("maybe"));
    EVENTUALLY2(ground->errors().contains("\"maybe\" is not an answer. Type yes or no:"), ground->errors().constData());
    ground->notify(QStringLiteral("yes"));
    QVERIFY(!desk->waitFor(QStringLiteral("pairing"), stateIs("confirmed")).isEmpty());
    QVERIFY(read("ground.peers").isEmpty() && read("air.peers").isEmpty()); // one yes is none
    desk->notify(QStringLiteral("yes"));
    EVENTUALLY2(desk->errors().contains("\"yes\" is not enough: the station needs a role. Type its role, pilot"),
                desk->errors().constData());
    desk->notify(QStringLiteral("pilot"));
    QCOMPARE(desk->waitForExit(), 0);
    QCOMPARE(ground->waitForExit(), 0);
    QVERIFY2(ground->errors().contains("was chosen at the agent"), ground->errors().constData());
    QCOMPARE(text(desk->last(QStringLiteral("pairing")), "state"), QStringLiteral("over"));
    QVERIFY2(read("ground.peers").startsWith("heron pilot any skyseal:"), read("ground.peers").constData());
    QVERIFY2(read("air.peers").startsWith("base pilot 255 skyseal:"), read("air.peers").constData());

    Program monitor(QStringLiteral("skyseal-cli"),
                    {QStringLiteral("monitor"), QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:%1").arg(m_port),
                     QStringLiteral("--identity"), path("ground.key"), QStringLiteral("--peers"), path("ground.peers"),
                     QStringLiteral("--no-record"), QStringLiteral("--json")});
    const QJsonObject session = monitor.waitFor(QStringLiteral("session"), stateIs("up"));
    QCOMPARE(text(session, "peer"), QStringLiteral("heron"));
}

void PairingTest::expectedFingerprintsNeedNoPerson()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto ground = station("ground.key", "ground.peers", m_port, expecting(m_air));
    const auto desk = window("air.key", expecting(QString(m_ground).remove(QLatin1Char(' ')).toUpper()));
    QCOMPARE(desk->waitForExit(), 0);
    QCOMPARE(ground->waitForExit(), 0);
    QVERIFY(read("air.peers").contains("psk=") && read("ground.peers").contains("psk=")); // a second secret for the pair
}

void PairingTest::oneNoIsEnough()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto ground = station("ground.key", "ground.peers", m_port);
    const auto desk = window("air.key");
    QVERIFY(!desk->waitFor(QStringLiteral("pairing"), stateIs("seen")).isEmpty());
    QVERIFY(!ground->waitFor(QStringLiteral("pairing"), stateIs("seen")).isEmpty());
    ground->notify(QStringLiteral("yes"));
    desk->notify(QStringLiteral("no"));
    QCOMPARE(desk->waitForExit(), 1);
    QCOMPARE(ground->waitForExit(), 1);
    QCOMPARE(text(ground->last(QStringLiteral("pairing")), "reason"), QStringLiteral("the other end refused"));
    QVERIFY(read("ground.peers").isEmpty() && read("air.peers").isEmpty());
}

/// Mallory poses as each end towards the other.
void PairingTest::somebodyInBetweenGetsNothing()
{
    const QString mallory = newKey("mallory.key"), malloryAir = newKey("mallory-air.key");
    const quint16 stolen = freeUdpPort(); // where the agent's datagrams end up
    const auto air = agent("air.key", "air.peers", stolen);
    QVERIFY(air);
    const auto toAgent = station("mallory.key", "mallory.peers", stolen, expecting(m_air));
    m_vehiclePort = freeUdpPort();
    const auto falseAir = agent("mallory-air.key", "mallory.peers", m_port);
    QVERIFY(falseAir);
    const auto toStation = window("mallory-air.key", expecting(m_ground));

    const auto desk = window("air.key", expecting(m_ground));
    const auto ground = station("ground.key", "ground.peers", m_port, expecting(m_air));
    QCOMPARE(text(desk->waitFor(QStringLiteral("pairing"), stateIs("seen")), "fingerprint"), mallory);
    QCOMPARE(text(ground->waitFor(QStringLiteral("pairing"), stateIs("seen")), "fingerprint"), malloryAir);
    QCOMPARE(toAgent->waitForExit(), 1);
    QCOMPARE(toStation->waitForExit(), 1);
    QVERIFY(desk->errors().contains("Not the expected fingerprint")
            && ground->errors().contains("Not the expected fingerprint"));
    for (const char *peers : {"ground.peers", "air.peers", "mallory.peers"})
        QVERIFY2(read(peers).isEmpty(), peers);
}

void PairingTest::changedKeyIsReplacedKnowingly()
{
    {
        const auto air = agent("air.key", "air.peers", m_port);
        const auto ground = station("ground.key", "ground.peers", m_port,
                                    expecting(m_air) + QStringList{QStringLiteral("--as"), QStringLiteral("heron")});
        QCOMPARE(window("air.key", expecting(m_ground))->waitForExit(), 0);
        QCOMPARE(ground->waitForExit(), 0);
    }
    const QString changed = newKey("new-air.key");
    m_vehiclePort = freeUdpPort();
    const auto air = agent("new-air.key", "mallory.peers", m_port);
    QVERIFY(air);
    const auto ground = station("ground.key", "ground.peers", m_port, {QStringLiteral("--as"), QStringLiteral("heron")});
    const auto desk = window("new-air.key", expecting(m_ground));
    const QJsonObject seen = ground->waitFor(QStringLiteral("pairing"), stateIs("seen"));
    QCOMPARE(text(seen, "fingerprint"), changed);
    QCOMPARE(text(seen, "known_fingerprint"), m_air);
    const QByteArray before = read("ground.peers");
    ground->notify(QStringLiteral("yes"));
    EVENTUALLY2(ground->errors().contains("\"yes\" does not replace a key. Type replace"), ground->errors().constData());
    ground->notify(QStringLiteral("replace"));
    QCOMPARE(ground->waitForExit(), 0);
    QVERIFY(read("ground.peers").startsWith("heron ") && read("ground.peers") != before);
    QCOMPARE(read("ground.peers").count('\n'), 1);
}

void PairingTest::expectedButChangedKeyIsRefused()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const QStringList named = {QStringLiteral("--as"), QStringLiteral("base")};
    {
        const auto ground = station("ground.key", "ground.peers", m_port, expecting(m_air));
        QCOMPARE(
            window("air.key", named + expecting(m_ground) + QStringList{QStringLiteral("--role"), QStringLiteral("observer")})
                ->waitForExit(),
            0);
        QCOMPARE(ground->waitForExit(), 0);
    }
    const QByteArray before = read("air.peers");
    QVERIFY2(before.startsWith("base observer "), before.constData());
    const QString other = newKey("other.key");
    {
        const auto ground = station("other.key", "mallory.peers", m_port, expecting(m_air));
        const auto desk = window("air.key", named + expecting(other));
        QCOMPARE(ground->waitForExit(), 1);
        QCOMPARE(desk->waitForExit(), 1);
        QVERIFY2(desk->errors().contains("only with --replace"), desk->errors().constData());
    }
    QCOMPARE(read("air.peers"), before);
    const auto ground = station("other.key", "mallory.peers", m_port, expecting(m_air));
    QCOMPARE(window("air.key", named + expecting(other) + QStringList{QStringLiteral("--replace")})->waitForExit(), 0);
    QVERIFY(read("air.peers") != before);
    QVERIFY2(read("air.peers").startsWith("base observer "), read("air.peers").constData()); // the role that was decided here
    QCOMPARE(read("air.peers").count('\n'), 1);
}

void PairingTest::observerIsKeptAsOne()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto ground = station("ground.key", "ground.peers", m_port, expecting(m_air));
    const auto desk = window("air.key", {QStringLiteral("--as"), QStringLiteral("tablet")});
    QVERIFY(!desk->waitFor(QStringLiteral("pairing"), stateIs("seen")).isEmpty());
    desk->notify(QStringLiteral("observer"));
    QCOMPARE(desk->waitForExit(), 0);
    QVERIFY2(read("air.peers").startsWith("tablet observer 255 "), read("air.peers").constData());
}

void PairingTest::knownRoleStays()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto pairAgain = [&](const QStringList &more) {
        const auto ground = station("ground.key", "ground.peers", m_port, expecting(m_air));
        QCOMPARE(window("air.key", QStringList{QStringLiteral("--as"), QStringLiteral("tablet")} + expecting(m_ground) + more)
                     ->waitForExit(),
                 0);
        QCOMPARE(ground->waitForExit(), 0);
    };
    pairAgain({}); // without an answer, a new station becomes an observer
    QVERIFY2(read("air.peers").startsWith("tablet observer "), read("air.peers").constData());
    pairAgain({});
    QVERIFY2(read("air.peers").startsWith("tablet observer "), read("air.peers").constData());
    pairAgain({QStringLiteral("--role"), QStringLiteral("pilot")});
    QVERIFY2(read("air.peers").startsWith("tablet pilot "), read("air.peers").constData());
}

/// A listed station that may use any system id keeps 255 when another one is paired.
void PairingTest::idsOfOtherStationsAreNotTaken()
{
    newKey("other.key");
    Program shown(QStringLiteral("skyseal-cli"),
                  {QStringLiteral("keys"), QStringLiteral("show"), path("other.key"), QStringLiteral("--json")});
    const QString key = text(shown.waitFor(QStringLiteral("key")), "public");
    QVERIFY(!key.isEmpty());
    QFile list(path("air.peers"));
    QVERIFY(list.open(QIODevice::Append));
    list.write("base pilot any " + key.toUtf8() + '\n');
    list.close();
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto ground = station("ground.key", "ground.peers", m_port, expecting(m_air));
    QCOMPARE(
        window("air.key", expecting(m_ground) + QStringList{QStringLiteral("--as"), QStringLiteral("tablet")})->waitForExit(),
        0);
    QVERIFY2(read("air.peers").contains("tablet observer any "), read("air.peers").constData());
}

/// Sends heartbeats as the autopilot until the program reports the event.
void PairingTest::sendHeartbeats(Program &until, const char *event, const Program::Predicate &predicate, bool armed)
{
    QUdpSocket autopilot;
    QVERIFY(autopilot.bind(QHostAddress::LocalHost, 0));
    QJsonObject heard;
    for (const QDeadlineTimer deadline(kDeadlineMs); heard.isEmpty() && !deadline.hasExpired();) {
        autopilot.writeDatagram(clearHeartbeat(1, 1, armed), QHostAddress::LocalHost, m_vehiclePort);
        autopilot.writeDatagram(clearHeartbeat(2, 1, false), QHostAddress::LocalHost,
                                m_vehiclePort); // another one, on the ground
        heard = until.waitFor(QLatin1String(event), predicate, 100);
    }
    QVERIFY(!heard.isEmpty());
}

void PairingTest::vehiclesIdIsNotBound()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto heard = [](const QJsonObject &stats) {
        return stats[QLatin1String("mavlink")].toObject()[QLatin1String("frames")].toInteger() > 0;
    };
    sendHeartbeats(*air, "stats", heard, false);
    const ClaimingStation claimer(m_port, 1);
    QVERIFY(claimer.isBound());
    const auto desk = window("air.key", {QStringLiteral("--as"), QStringLiteral("tablet")});
    QCOMPARE(desk->waitFor(QStringLiteral("pairing"), stateIs("seen"))[QLatin1String("system")].toInt(), 1);
    desk->notify(QStringLiteral("observer"));
    QCOMPARE(desk->waitForExit(), 0);
    QVERIFY2(read("air.peers").startsWith("tablet observer any "), read("air.peers").constData());
    QVERIFY2(desk->errors().contains("WARNING: its system ID 1 is that of a vehicle here, and was not bound"),
             desk->errors().constData());
}

void PairingTest::armedVehicleOpensNoWindow()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto heard = [](const QJsonObject &stats) {
        return stats[QLatin1String("mavlink")].toObject()[QLatin1String("frames")].toInteger() > 0;
    };
    sendHeartbeats(*air, "stats", heard, true);
    const auto refused = window("air.key");
    QCOMPARE(refused->waitForExit(), 1);
    QCOMPARE(text(refused->last(QStringLiteral("pairing")), "reason"), QStringLiteral("the vehicle is armed"));
}

void PairingTest::armingClosesTheWindow()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto desk = window("air.key");
    QVERIFY(!desk->waitFor(QStringLiteral("pairing"), stateIs("open")).isEmpty());
    sendHeartbeats(*desk, "pairing", stateIs("over"), true);
    QCOMPARE(desk->waitForExit(), 1);
    QCOMPARE(text(desk->last(QStringLiteral("pairing")), "reason"), QStringLiteral("the vehicle was armed"));
}

void PairingTest::leavingClosesTheWindow()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    for (const bool killed : {false, true}) {
        auto desk = window("air.key");
        QVERIFY(!desk->waitFor(QStringLiteral("pairing"), stateIs("open")).isEmpty());
        if (killed)
            desk->kill();
        else
            QCOMPARE(desk->terminate(), 1);
        QVERIFY(!air->waitFor(QStringLiteral("pairing"), stateIs("over")).isEmpty());
    }
}

void PairingTest::nobodyToAnswerIsTold()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const RunResult ended = runProgram("skyseal-air",
                                       {QStringLiteral("--pair"), QStringLiteral("--identity"), path("air.key")});
    QCOMPARE(ended.status, 1);
    QVERIFY2(ended.err.contains("standard input has ended") && ended.err.contains("--expect"), ended.err.constData());
}

void PairingTest::oneVisitorAtATime()
{
    QCOMPARE(window("air.key")->waitForExit(), 3); // no agent runs
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto first = window("air.key");
    QVERIFY(!first->waitFor(QStringLiteral("pairing"), stateIs("open")).isEmpty());
    const auto second = window("air.key");
    QCOMPARE(second->waitForExit(), 1);
    QVERIFY(first->running());
    const auto mode = QFile::permissions(path("air.key.control"));
    QVERIFY(!(mode & (QFile::ReadOther | QFile::WriteOther | QFile::ReadGroup | QFile::WriteGroup)));
}

QString PairingTest::passphraseFile(const char *name, const QByteArray &words) const
{
    QFile file(path(name));
    if (file.open(QIODevice::WriteOnly))
        file.write(words + '\n');
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    return file.fileName();
}

void PairingTest::passphraseOfBothEnds()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    // One end reads it from a file, the other from the first line of standard input; the next lines there are answers.
    const auto ground = station("ground.key", "ground.peers", m_port,
                                {QStringLiteral("--pair-passphrase-file"), passphraseFile("words", "blue heron at noon")});
    const auto desk = window("air.key", {QStringLiteral("--pair-passphrase-file"), QStringLiteral("-")});
    desk->notify(QStringLiteral("blue heron at noon"));
    QVERIFY(!desk->waitFor(QStringLiteral("pairing"), stateIs("seen")).isEmpty());
    QVERIFY(!ground->waitFor(QStringLiteral("pairing"), stateIs("seen")).isEmpty());
    EVENTUALLY2(ground->errors().contains("It knows the passphrase"), ground->errors().constData());
    desk->notify(QStringLiteral("pilot"));
    ground->notify(QStringLiteral("yes"));
    QCOMPARE(desk->waitForExit(), 0);
    QCOMPARE(ground->waitForExit(), 0);
    QVERIFY(read("air.peers").contains("skyseal:") && read("ground.peers").contains("skyseal:"));
    for (Program *program : {air.get(), ground.get(), desk.get()})
        QVERIFY2(!program->errors().contains("heron at"), program->errors().constData());
}

void PairingTest::wrongPassphraseIsTold()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto ground = station("ground.key", "ground.peers", m_port,
                                {QStringLiteral("--pair-passphrase-file"), passphraseFile("right", "blue heron at noon")});
    const auto desk = window("air.key",
                             {QStringLiteral("--pair-passphrase-file"), passphraseFile("wrong", "grey heron at noon")});
    QVERIFY(!ground->waitFor(QStringLiteral("pairing"), stateIs("passphrase-differs")).isEmpty());
    QVERIFY(!desk->waitFor(QStringLiteral("pairing"), stateIs("passphrase-differs")).isEmpty());
    for (Program *program : {ground.get(), desk.get()})
        EVENTUALLY2(program->errors().contains("passphrases of the two ends differ"), program->errors().constData());
    QCOMPARE(ground->waitForExit(), 1);
    QVERIFY2(text(ground->last(QStringLiteral("pairing")), "reason").contains(QStringLiteral("interrupted")),
             ground->errors().constData());
    QVERIFY(desk->running()); // two more guesses
    for (Program *program : {ground.get(), desk.get()}) {
        QCOMPARE(program->errors().count("passphrases of the two ends differ"), 1);
        QVERIFY(!program->errors().contains("requests pairing"));
    }
}

void PairingTest::passphraseAtOneEndIsTold()
{
    const auto air = agent("air.key", "air.peers", m_port);
    QVERIFY(air);
    const auto ground = station("ground.key", "ground.peers", m_port);
    const auto desk = window("air.key",
                             {QStringLiteral("--pair-passphrase-file"), passphraseFile("words", "blue heron at noon")});
    QVERIFY(!ground->waitFor(QStringLiteral("pairing"), stateIs("passphrase-differs")).isEmpty());
    QVERIFY(ground->waitFor(QStringLiteral("pairing"), stateIs("seen"), 1500).isEmpty());
    QVERIFY(read("ground.peers").isEmpty() && read("air.peers").isEmpty());
}

SKYSEAL_TEST(PairingTest)
#include "pairing_test.moc"
