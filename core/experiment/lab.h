// The far end of a sweep without a given link: a simulated vehicle, the real agent and, for an impaired link, a relay. Each is
// a separate process, with fresh keys in a temporary folder, so that the measured process contains none of them. Lives on the
// thread of its owner.
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/engine/station/station_config.h"
#include "core/experiment/placement.h"
#include "core/experiment/plan.h"

#include <QtCore/QObject>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>

#include <memory>

namespace skyseal::experiment {

/// Paths of the programs.
struct LabPrograms
{
    QString simulator; ///< skyseal-sim
    QString agent;     ///< skyseal-air
    QString relay;     ///< skyseal-cli, for its "impair"
};

class Lab : public QObject
{
    Q_OBJECT

public:
    static Result<std::unique_ptr<Lab>, InputError> create(LabPrograms programs, RandomSource &random);
    ~Lab() override;

    engine::KeyPaths stationKeys() const;
    /// UDP port on 127.0.0.1 on which the station must listen.
    quint16 groundPort() const { return m_groundPort; }
    /// Stops the running programs and starts them again. The agent allows plain MAVLink, inline framing and research suites,
    /// since it is reachable on loopback only.
    void start(Load load, const Condition &condition, std::uint64_t seed);
    void stop();
    /// Process ids; 0 for a program that does not run.
    qint64 agentProcess() const { return m_agent.processId(); }
    qint64 simulatorProcess() const { return m_simulator.processId(); }
    qint64 relayProcess() const { return m_relay.processId(); }
    /// Which core each program runs on. The owner of the station places that.
    const Placement &placement() const { return m_placement; }

Q_SIGNALS:
    /// A program ended unexpectedly or could not be started. `problem` is a sentence with the reason.
    void ended(const QString &problem);

private:
    explicit Lab(LabPrograms programs);

    void launch(QProcess &process, const QString &program, const QStringList &arguments);
    void reportEnd(const QProcess &process);
    QString file(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    LabPrograms m_programs;
    const Placement m_placement = placementHere();
    QTemporaryDir m_folder;
    QProcess m_simulator, m_agent, m_relay;
    quint16 m_vehiclePort, m_relayPort, m_groundPort;
    bool m_stopping = false;
};

} // namespace skyseal::experiment
