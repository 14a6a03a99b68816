// The far end of a sweep that was given no link: a simulated vehicle, the real agent beside it and, where the link shall be
// bad, the relay that makes it so, each a process of its own, with fresh keys in a temporary folder. Nothing of it is part
// of the measured process. Lives on the thread of its owner.
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/engine/station/station_config.h"
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
    /// Where the station is to listen.
    quint16 groundPort() const { return m_groundPort; }
    /// Ends what runs and starts anew. The agent consents to plain MAVLink, inline framing and research suites: it is
    /// our own, on loopback.
    void start(Load load, const Condition &condition, std::uint64_t seed);
    void stop();
    qint64 agentProcess() const { return m_agent.processId(); }

Q_SIGNALS:
    /// One of the programs ended by itself or could not be started: a sentence that says why.
    void ended(const QString &problem);

private:
    explicit Lab(LabPrograms programs);

    void launch(QProcess &process, const QString &program, const QStringList &arguments);
    void tellEnd(const QProcess &process);
    QString file(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    LabPrograms m_programs;
    QTemporaryDir m_folder;
    QProcess m_simulator, m_agent, m_relay;
    quint16 m_vehiclePort, m_relayPort, m_groundPort;
    bool m_stopping = false;
};

} // namespace skyseal::experiment
