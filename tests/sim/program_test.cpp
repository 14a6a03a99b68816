// The real program on real sockets: its output, its exit status, and its answers to every sender.
#include "core/mavlink/frame_scanner.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QProcess>
#include <QtNetwork/QNetworkDatagram>
#include <QtNetwork/QTcpSocket>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

#include <set>

using namespace skyseal;

class SimProgramTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void usageErrors_data();
    void usageErrors();
    void takenPortIsExitThree();
    void sendsToItsPeerAndEndsOnRequest();
    void answersWhoeverSpoke();
    void servesTcp();

private:
    static QString program() { return QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-sim"); }
    /// The port that it says it listens on; 0 when it does not.
    static quint16 portOf(QProcess &sim);
    static Bytes heartbeat();
    static void stop(QProcess &sim);
};

quint16 SimProgramTest::portOf(QProcess &sim)
{
    while (sim.canReadLine() || sim.waitForReadyRead(test::kDeadlineMs)) {
        if (!sim.canReadLine())
            continue;
        const QJsonObject line = QJsonDocument::fromJson(sim.readLine()).object();
        if (line[QLatin1String("state")].toString() == QLatin1String("listening"))
            return static_cast<quint16>(line[QLatin1String("address")].toString().section(QLatin1Char(':'), -1).toUInt());
    }
    return 0;
}

Bytes SimProgramTest::heartbeat()
{
    mavlink::FrameWriter writer(255, 190);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const auto bytes = writer.write(mavlink::Heartbeat{}, buffer);
    return {bytes.begin(), bytes.end()};
}

void SimProgramTest::stop(QProcess &sim)
{
    sim.terminate();
    QVERIFY(sim.waitForFinished(test::kDeadlineMs));
    QCOMPARE(sim.exitStatus(), QProcess::NormalExit);
    QCOMPARE(sim.exitCode(), 0);
}

void SimProgramTest::usageErrors_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("words");
    const auto list = [](const char *text) { return QString::fromLatin1(text).split(QLatin1Char(' '), Qt::SkipEmptyParts); };
    QTest::newRow("no link") << list("") << QStringLiteral("--link is missing");
    QTest::newRow("bad link") << list("--link gopher:1") << QStringLiteral("gopher");
    QTest::newRow("log") << list("--link tlog:x.tlog") << QStringLiteral("log");
    QTest::newRow("bad rate") << list("--link udpout:127.0.0.1:9 --rate fast") << QStringLiteral("'fast'");
    QTest::newRow("too many") << list("--link udpout:127.0.0.1:9 --sysid 250 --vehicles 9") << QStringLiteral("254");
    QTest::newRow("kind") << list("--link udpout:127.0.0.1:9 --kind boat") << QStringLiteral("'boat'");
    QTest::newRow("autopilot") << list("--link udpout:127.0.0.1:9 --autopilot inav") << QStringLiteral("'inav'");
    QTest::newRow("combination") << list("--link udpout:127.0.0.1:9 --kind rover --autopilot px4")
                                 << QStringLiteral("copter only");
    QTest::newRow("unknown") << list("--link udpout:127.0.0.1:9 --fly") << QStringLiteral("fly");
    QTest::newRow("argument") << list("--link udpout:127.0.0.1:9 now") << QStringLiteral("'now'");
}

void SimProgramTest::usageErrors()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, words);
    QProcess sim;
    sim.start(program(), arguments);
    QVERIFY(sim.waitForFinished(test::kDeadlineMs));
    QCOMPARE(sim.exitCode(), 2);
    const QString said = QString::fromUtf8(sim.readAllStandardError());
    QVERIFY2(said.contains(words), qPrintable(said));
    QCOMPARE(said.count(QLatin1Char('\n')), 1);
}

void SimProgramTest::takenPortIsExitThree()
{
    QUdpSocket taken;
    QVERIFY(taken.bind(QHostAddress::LocalHost, 0, QAbstractSocket::DontShareAddress));
    QProcess sim;
    sim.start(program(), {QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:%1").arg(taken.localPort())});
    QVERIFY(sim.waitForFinished(test::kDeadlineMs));
    QCOMPARE(sim.exitCode(), 3);
    QVERIFY(sim.readAllStandardError().contains(QByteArray::number(taken.localPort())));
}

void SimProgramTest::sendsToItsPeerAndEndsOnRequest()
{
    QUdpSocket station;
    QVERIFY(station.bind(QHostAddress::LocalHost, 0));
    QProcess sim;
    sim.start(program(),
              {QStringLiteral("--link"), QStringLiteral("udpout:127.0.0.1:%1").arg(station.localPort()),
               QStringLiteral("--vehicles"), QStringLiteral("3"), QStringLiteral("--sysid"), QStringLiteral("7")});
    std::set<int> systems;
    const auto heard = [&] {
        while (station.hasPendingDatagrams()) {
            const QByteArray bytes = station.receiveDatagram().data();
            const ByteView view(reinterpret_cast<const std::uint8_t *>(bytes.constData()),
                                static_cast<std::size_t>(bytes.size()));
            const auto frame = mavlink::readFrame(view, mavlink::Dialect::builtin());
            if (frame && frame->bytes().size() == view.size() && frame->messageId() == mavlink::Heartbeat::kId)
                systems.insert(frame->systemId());
        }
        return systems.size() == 3;
    };
    EVENTUALLY(heard());
    QCOMPARE(systems, (std::set<int>{7, 8, 9}));
    QByteArray said;
    EVENTUALLY((said += sim.readAllStandardOutput()).startsWith("skyseal-sim: vehicles 7 to 9 connected to udpout:127.0.0.1:"));
    stop(sim);
}

void SimProgramTest::answersWhoeverSpoke()
{
    QProcess sim;
    sim.start(program(), {QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:0"), QStringLiteral("--json")});
    const quint16 port = portOf(sim);
    QVERIFY(port != 0);
    QUdpSocket silent, first, second;
    for (QUdpSocket *socket : {&silent, &first, &second})
        QVERIFY(socket->bind(QHostAddress::LocalHost, 0));
    const Bytes hello = heartbeat();
    for (QUdpSocket *socket : {&first, &second})
        socket->writeDatagram(reinterpret_cast<const char *>(hello.data()), static_cast<qint64>(hello.size()),
                              QHostAddress::LocalHost, port);
    silent.writeDatagram("noise", QHostAddress::LocalHost, port); // no frame: not a station
    EVENTUALLY(first.hasPendingDatagrams() && second.hasPendingDatagrams());
    QVERIFY(!silent.hasPendingDatagrams());
    stop(sim);
}

void SimProgramTest::servesTcp()
{
    QProcess sim;
    sim.start(program(), {QStringLiteral("--link"), QStringLiteral("tcpin:127.0.0.1:0"), QStringLiteral("--json")});
    const quint16 port = portOf(sim);
    QVERIFY(port != 0);
    for (int visit = 0; visit < 2; ++visit) { // clients come and go
        QTcpSocket station;
        station.connectToHost(QHostAddress::LocalHost, port);
        QByteArray received;
        const auto framed = [&] {
            received += station.readAll();
            mavlink::FrameScanner scanner(
                {reinterpret_cast<const std::uint8_t *>(received.constData()), static_cast<std::size_t>(received.size())},
                mavlink::Dialect::builtin());
            int frames = 0;
            while (const auto item = scanner.next())
                frames += item->frame ? 1 : 0;
            return frames > 20;
        };
        EVENTUALLY(framed());
    }
    stop(sim);
}

SKYSEAL_TEST(SimProgramTest)
#include "program_test.moc"
