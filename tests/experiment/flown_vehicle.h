// An autopilot that runs already, for sweeps beside it: the simulator, and a monitor on a second link of it that shows what the
// vehicle does.
#pragma once

#include "tests/support/program.h"
#include "tests/support/run_program.h"

#include <QtCore/QJsonValue>

namespace skyseal::test {

inline constexpr const char *kToFiveMetres = "wait ekf_ok==1 90; mode GUIDED; arm; takeoff 5; wait alt_rel>=4.5 60";

struct FlownVehicle
{
    quint16 port = freeTcpPort(), witnessPort = freeUdpPort();
    QString simulatorLink = QStringLiteral("tcpin:127.0.0.1:%1").arg(port);
    QString agentLink = QStringLiteral("tcp:127.0.0.1:%1").arg(port); ///< the --vehicle of a sweep
    Program sim{QStringLiteral("skyseal-sim"),
                QStringLiteral("--link %1 --link udpout:127.0.0.1:%2 --rate 4 --json")
                    .arg(simulatorLink)
                    .arg(witnessPort)
                    .split(QLatin1Char(' '))};
    Program witness{QStringLiteral("skyseal-cli"),
                    QStringLiteral("monitor --secure off --no-record --json --link udpin:127.0.0.1:%1")
                        .arg(witnessPort)
                        .split(QLatin1Char(' '))};

    FlownVehicle() = default;
    FlownVehicle(QString ofSimulator, QString ofAgent) : simulatorLink(std::move(ofSimulator)), agentLink(std::move(ofAgent)) {}

    QJsonValue now() { return witness.last(QStringLiteral("stats"))[QLatin1String("vehicles")][0]; }
    bool isFlying() { return now()[QLatin1String("armed")].toBool() && now()[QLatin1String("alt_rel")].toDouble() > 3.5; }
    bool isDown() { return !now()[QLatin1String("armed")].toBool(true) && now()[QLatin1String("alt_rel")].toDouble(100) < 1; }
    /// Of the events so far.
    int landings()
    {
        int out = 0;
        bool armed = false;
        for (const QJsonObject &event : witness.events(QStringLiteral("stats"))) {
            const bool isArmed = event[QLatin1String("vehicles")][0][QLatin1String("armed")].toBool(armed);
            out += armed && !isArmed;
            armed = isArmed;
        }
        return out;
    }
    QStringList sweep(const QString &script, const char *more) const
    {
        return QStringList{QStringLiteral("sweep"), QStringLiteral("--vehicle"), agentLink, QStringLiteral("--fly"), script,
                           QStringLiteral("--json")}
        + words(more);
    }
};

} // namespace skyseal::test
