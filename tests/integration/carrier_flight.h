// A flight of real programs over serial lines, TCP and MAVLink routers. Shared by the tests of carriers.
#pragma once

#include "tests/support/flight.h"
#include "tests/support/record_counters.h"

#include <QtCore/QJsonDocument>
#include <QtTest/QTest>

#include <algorithm>

namespace skyseal::test {

inline constexpr int kSeconds = 20; // of streams after the take-off

/// What the flight script did, a line per step that ended, for the message of a failed test.
inline QByteArray stepsOf(Program &monitor)
{
    QByteArray out;
    for (const QJsonObject &step : monitor.events(QStringLiteral("command")))
        out += QJsonDocument(step).toJson(QJsonDocument::Compact) + '\n';
    return out;
}

inline QStringList with(QStringList arguments, const char *option, const QString &value)
{
    const qsizetype at = arguments.indexOf(QLatin1String(option));
    if (at >= 0)
        arguments[at + 1] = value;
    return arguments;
}

inline QString serial(const QString &device, int baud)
{
    return QStringLiteral("serial:%1:%2").arg(device).arg(baud);
}

inline QStringList words(std::initializer_list<const char *> texts)
{
    QStringList out;
    for (const char *text : texts)
        out += QLatin1String(text);
    return out;
}

inline qint64 number(const QJsonObject &object, const char *key)
{
    return object[QLatin1String(key)].toInteger();
}

/// The links of a flight.
struct CarrierWay
{
    QString ground;       ///< the agent's --ground
    QString station;      ///< the monitor's --link
    QString carrier;      ///< empty: the default
    int rate = 20;        ///< Hz of each stream
    bool spoofed = false; ///< an attacker sends clear frames as well
};

/// Switches through all suites and ends with a command. Verifies that nothing is lost.
inline void fly(Flight &flight, const CarrierWay &way, const char *carrier)
{
    QVERIFY(flight.ready());
    QStringList air = with(flight.airArguments(), "--ground", way.ground);
    if (!way.carrier.isEmpty())
        air += {QStringLiteral("--carrier"), way.carrier};
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program agent(QStringLiteral("skyseal-air"), air);
    Program monitor(QStringLiteral("skyseal-cli"),
                    with(flight.monitorArguments(), "--link", way.station)
                        + words({"--do", "wait ekf_ok==1 60; mode GUIDED; arm; takeoff 3; wait alt_rel>=2.5 60; sleep 20",
                                 "--switch-every", "1.5", "--switch-to"})
                        + QStringList{allSuites(), QStringLiteral("--stream-rate"), QString::number(way.rate)});
    const QJsonObject session = monitor.waitFor(QStringLiteral("session"));
    QVERIFY2(session[QLatin1String("state")] == QLatin1String("up"), monitor.errors() + agent.errors());
    QCOMPARE(session[QLatin1String("carrier")].toString(), QLatin1String(carrier));
    const QJsonObject vehicle = monitor.waitFor(QStringLiteral("vehicle"));
    QCOMPARE(number(vehicle, "sysid"), 1);
    const int status = monitor.waitForExit(4 * kDeadlineMs);
    QVERIFY2(status == 0, monitor.errors() + stepsOf(monitor));

    const QJsonObject summary = monitor.last(QStringLiteral("summary"));
    const QJsonObject mavlink = summary[QLatin1String("mavlink")].toObject();
    const QJsonValue channel = summary[QLatin1String("channel")];
    const QJsonObject received = receivedRecords(channel);
    QVERIFY2(number(mavlink, "frames") > 300, qPrintable(QString::number(number(mavlink, "frames"))));
    for (const char *counter : {"lost", "duplicate", "bad_crc"})
        QVERIFY2(number(mavlink, counter) == 0, counter);
    for (const char *counter : {"lost", "replayed", "forged", "malformed"})
        QVERIFY2(number(received, counter) == 0, counter);
    const QJsonObject unmatched = channel[QLatin1String("unmatched")].toObject();
    QCOMPARE(number(unmatched, "forged"), 0);
    // On a busy machine answers may come after their attempts were given up; an error of the carrier would make hundreds.
    QVERIFY2(number(unmatched, "malformed") <= 20, qPrintable(QString::number(number(unmatched, "malformed"))));
    QCOMPARE(number(received, "plaintext_dropped") > 0, way.spoofed);
    const auto sessions = monitor.events(QStringLiteral("session"));
    QCOMPARE(std::count_if(sessions.begin(), sessions.end(),
                           [](const QJsonObject &event) { return event[QLatin1String("state")] == QLatin1String("up"); }),
             1);
    std::size_t committed = 0;
    for (const QJsonObject &event : monitor.events(QStringLiteral("switch"))) {
        QVERIFY2(event[QLatin1String("result")] == QLatin1String("committed"), QJsonDocument(event).toJson());
        ++committed;
    }
    QVERIFY(committed >= 6);
    QCOMPARE(agent.terminate(), 0);
    qInfo("%s: %lld frames in %lld records", carrier, static_cast<long long>(number(mavlink, "frames")),
          static_cast<long long>(number(received, "good")));
}

} // namespace skyseal::test
