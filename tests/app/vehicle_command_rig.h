// Commands of skyseal-cli for one vehicle: the simulator behind an agent, over the sealed link.
#pragma once

#include "tests/support/flight.h"
#include "tests/support/run_program.h"

#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include <memory>
#include <vector>

namespace skyseal::test {

class VehicleCommandRig
{
public:
    /// Starts the simulator and the agent; false if there are no keys. `impairment`: options of skyseal-cli impair, which then
    /// relays between the agent and the station.
    bool start(const QStringList &impairment = {})
    {
        if (!m_flight.ready())
            return false;
        const quint16 ground = impairment.isEmpty() ? m_flight.groundPort : freeUdpPort();
        if (!impairment.isEmpty()) {
            const QStringList ends{QStringLiteral("impair"), QStringLiteral("--listen"),
                                   QStringLiteral("udpin:127.0.0.1:%1").arg(ground), QStringLiteral("--to"),
                                   QStringLiteral("udpout:127.0.0.1:%1").arg(m_flight.groundPort)};
            m_relay = std::make_unique<Program>(QStringLiteral("skyseal-cli"), ends + impairment);
        }
        m_sim = std::make_unique<Program>(QStringLiteral("skyseal-sim"), m_flight.simArguments());
        m_air = std::make_unique<Program>(QStringLiteral("skyseal-air"), m_flight.airArguments(ground));
        return true;
    }

    /// Null without impairment.
    Program *relay() { return m_relay.get(); }

    QString path(const QString &name) const { return m_flight.path(name); }

    /// "param set A=1": its first two words, then the link and the keys, then the others.
    QStringList arguments(const QString &command, const QStringList &more = {}) const
    {
        const QStringList words = command.split(QLatin1Char(' '));
        const QStringList link = {QStringLiteral("--link"),     QStringLiteral("udpin:127.0.0.1:%1").arg(m_flight.groundPort),
                                  QStringLiteral("--identity"), path(QStringLiteral("ground.key")),
                                  QStringLiteral("--peers"),    path(QStringLiteral("ground.peers")),
                                  QStringLiteral("--sysid"),    QStringLiteral("1")};
        return words.mid(0, 2) + link + words.mid(2) + more;
    }
    RunResult run(const QString &command, const QStringList &more = {}) const
    {
        return runProgram("skyseal-cli", arguments(command, more));
    }
    /// Flies a script of `monitor`.
    RunResult fly(const QString &script) const
    {
        return runProgram("skyseal-cli", m_flight.monitorArguments({QStringLiteral("--do"), script}));
    }

    /// Writes a file in the folder of the test; returns its path, or an empty text.
    QString write(const char *name, const QByteArray &content) const
    {
        QFile file(path(QLatin1String(name)));
        const bool ok = file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
        return ok ? file.fileName() : QString();
    }

private:
    Flight m_flight;
    std::unique_ptr<Program> m_relay, m_sim, m_air;
};

/// The JSON objects of this kind on standard output.
inline std::vector<QJsonObject> eventsIn(const RunResult &result, const QString &kind)
{
    std::vector<QJsonObject> out;
    for (const QByteArray &line : result.out.split('\n')) {
        const QJsonObject event = QJsonDocument::fromJson(line).object();
        if (event[QLatin1String("event")].toString() == kind)
            out.push_back(event);
    }
    return out;
}

} // namespace skyseal::test
