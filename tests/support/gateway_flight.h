// A flight behind a gateway: simulator or another vehicle, agent, and skyseal-cli gateway with its options in a file.
#pragma once

#include "tests/support/flight.h"
#include "tests/support/run_program.h"

#include <QtCore/QFile>

#include <memory>

namespace skyseal::test {

class GatewayFlight
{
public:
    /// Starts the gateway. `serve`: values of --serve; `more`: further lines of its configuration.
    explicit GatewayFlight(const QStringList &serve, const QByteArrayList &more = {})
    {
        QFile config(configFile());
        if (!flight.ready() || !config.open(QIODevice::WriteOnly))
            qFatal("no keys");
        const auto line = [&config](const char *name, const QString &value) {
            config.write(name + QByteArray(" = ") + value.toUtf8() + '\n');
        };
        line("link", QStringLiteral("udpin:127.0.0.1:%1").arg(flight.groundPort));
        line("identity", flight.path(QStringLiteral("ground.key")));
        line("peers", flight.path(QStringLiteral("ground.peers")));
        for (const QString &one : serve)
            line("serve", one);
        line("control", QStringLiteral("unix:") + socket);
        line("metrics", QStringLiteral("127.0.0.1:%1").arg(metricsPort));
        line("no-record", QStringLiteral("yes"));
        line("json", QStringLiteral("yes"));
        for (const QByteArray &one : more)
            config.write(one + '\n');
        config.close();
        config.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        startGateway();
    }

    void startGateway()
    {
        gateway = std::make_unique<Program>(QStringLiteral("skyseal-cli"),
                                            QStringList{QStringLiteral("gateway"), QStringLiteral("--config"), configFile()});
    }
    /// `vehicle`: the agent's link to it.
    void startAgent(const QString &vehicle)
    {
        QStringList arguments = flight.airArguments();
        arguments[arguments.indexOf(QStringLiteral("--vehicle")) + 1] = vehicle;
        air = std::make_unique<Program>(QStringLiteral("skyseal-air"), arguments);
    }
    void startSimulatedVehicle()
    {
        sim = std::make_unique<Program>(QStringLiteral("skyseal-sim"), flight.simArguments());
        air = std::make_unique<Program>(QStringLiteral("skyseal-air"), flight.airArguments());
    }

    RunResult control(QStringList arguments) const
    {
        return runProgram("skyseal-cli", arguments << QStringLiteral("--control") << QStringLiteral("unix:") + socket);
    }
    /// The suites that the gateway offers: all but those for research.
    static QStringList suites()
    {
        QStringList out = allSuites().split(QLatin1Char(','));
        out.removeAll(QStringLiteral("rc4"));
        return out;
    }
    bool waitForSession()
    {
        return !gateway
                    ->waitFor(QStringLiteral("session"),
                              [](const QJsonObject &session) {
                                  return session[QLatin1String("state")].toString() == QLatin1String("up");
                              })
                    .isEmpty();
    }

    Flight flight;
    const QString socket = flight.path(QStringLiteral("control"));
    const quint16 metricsPort = freeTcpPort();
    std::unique_ptr<Program> gateway, sim, air;

private:
    QString configFile() const { return flight.path(QStringLiteral("gateway.conf")); }
};

/// Another ground station, which knows nothing of sealing.
inline std::unique_ptr<Program> plainStation(quint16 port, const QStringList &more)
{
    return std::make_unique<Program>(QStringLiteral("skyseal-cli"),
                                     QStringList{QStringLiteral("monitor"), QStringLiteral("--link"),
                                                 QStringLiteral("udpin:127.0.0.1:%1").arg(port), QStringLiteral("--secure"),
                                                 QStringLiteral("off"), QStringLiteral("--no-record"), QStringLiteral("--json")}
                                         + more);
}

/// Switches the suites of the gateway in turn until the station ends its flight. Returns the number of switches; 0 if one
/// failed.
inline int switchWhileFlying(const GatewayFlight &flight, Program &station, int everySeconds)
{
    const QStringList suites = GatewayFlight::suites();
    int switched = 0;
    while (station.running()) {
        if (flight.control({QStringLiteral("switch"), suites[switched++ % suites.size()]}).status != 0)
            return 0;
        for (int second = 0; second < everySeconds && station.running(); ++second)
            station.waitFor(QStringLiteral("stats"));
    }
    return switched;
}

} // namespace skyseal::test
