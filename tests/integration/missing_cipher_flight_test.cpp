// An agent or a station on a machine without OpenSSL's legacy provider, hence without RC4, which the other end has and asks
// for: the wish is turned down, and the flight goes on.
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::test;

namespace {

/// Started where OpenSSL finds no modules.
class WithoutModules
{
public:
    explicit WithoutModules(bool wanted) : m_before(qgetenv("OPENSSL_MODULES"))
    {
        if (wanted)
            qputenv("OPENSSL_MODULES", "/nonexistent");
    }
    ~WithoutModules()
    {
        if (m_before.isEmpty())
            qunsetenv("OPENSSL_MODULES");
        else
            qputenv("OPENSSL_MODULES", m_before);
    }

private:
    QByteArray m_before;
};

} // namespace

class MissingCipherFlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneEndLacksRc4_data();
    void oneEndLacksRc4();
};

void MissingCipherFlightTest::oneEndLacksRc4_data()
{
    QTest::addColumn<bool>("inTheAir");
    QTest::addColumn<QString>("answer");
    QTest::newRow("agent") << true << QStringLiteral("not-allowed-by-peer");
    QTest::newRow("station") << false << QStringLiteral("not-allowed-here");
}

void MissingCipherFlightTest::oneEndLacksRc4()
{
    QFETCH(bool, inTheAir);
    QFETCH(QString, answer);
    Flight flight;
    QVERIFY(flight.ready());
    std::optional<Program> air;
    std::optional<Program> monitor;
    {
        const WithoutModules without(inTheAir);
        air.emplace(QStringLiteral("skyseal-air"), flight.airArguments());
        QVERIFY2(!air->waitFor(QStringLiteral("link")).isEmpty(), air->errors().constData());
    }
    {
        const WithoutModules without(!inTheAir);
        monitor.emplace(QStringLiteral("skyseal-cli"),
                        flight.monitorArguments({QStringLiteral("--switch-to"), QStringLiteral("rc4,aes-256-gcm"),
                                                 QStringLiteral("--switch-every"), QStringLiteral("1")}));
        QVERIFY2(!monitor->waitFor(QStringLiteral("session")).isEmpty(), monitor->errors().constData());
    }
    const auto result = [&](const char *suite) {
        const QJsonObject event = monitor->waitFor(QStringLiteral("switch"), [suite](const QJsonObject &done) {
            return done[QLatin1String("to")].toString() == QLatin1String(suite);
        });
        const QString reason = event[QLatin1String("reason")].toString();
        return reason.isEmpty() ? event[QLatin1String("result")].toString() : reason;
    };
    QCOMPARE(result("rc4"), answer);
    QCOMPARE(result("aes-256-gcm"), QStringLiteral("committed"));
    QCOMPARE(result("rc4"), answer);
    QVERIFY(air->running());
    QVERIFY(monitor->running());
    QCOMPARE(monitor->terminate(), 1); // as always when a suite that was asked for never came into use
    QVERIFY(monitor->errors().contains("never came into use: rc4"));
    QCOMPARE(air->terminate(), 0);
}

SKYSEAL_TEST(MissingCipherFlightTest)
#include "missing_cipher_flight_test.moc"
