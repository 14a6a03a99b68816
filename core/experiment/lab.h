// The far end of a sweep without a given link: a simulated vehicle or an autopilot that runs already, the real agent and, for
// an impaired link, a relay. Each is a separate process, with fresh keys in a temporary folder, so that the measured process
// contains none of them. Lives on the thread of its owner.
#pragma once

#include "core/base/random_source.h"
#include "core/base/reason.h"
#include "core/base/result.h"
#include "core/engine/station/station_config.h"
#include "core/experiment/measurement.h"
#include "core/experiment/placement.h"
#include "core/experiment/plan.h"
#include "core/experiment/relay_log.h"
#include "core/link/link_url.h"
#include "core/link/port_owner.h"

#include <QtCore/QObject>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>

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
    /// `vehicle`: the agent's link to an autopilot that runs already; nullopt: the lab starts the simulator.
    static Result<std::unique_ptr<Lab>, InputError> create(LabPrograms programs, RandomSource &random,
                                                           std::optional<link::LinkUrl> vehicle = std::nullopt,
                                                           const Placement &placement = placementHere());
    ~Lab() override;

    engine::KeyPaths stationKeys() const;
    /// Key file of the bare ciphers, see setBareCipher().
    std::string bareKey() const { return file("bare.key").toStdString(); }
    /// UDP port on 127.0.0.1 on which the station must listen.
    quint16 groundPort() const { return m_groundPort; }
    /// Stops the running programs and starts them again. The agent allows plain MAVLink, inline framing and research suites,
    /// since it is reachable on loopback only.
    void start(Load load, const Condition &condition, std::uint64_t seed);
    void stop();
    /// Has the simulator that runs encrypt the payloads that it sends; nullopt: no longer. It begins in clear. Without effect
    /// on an autopilot.
    void setBareCipher(std::optional<crypto::MavsecKind> cipher);
    /// Resource usage of the programs now, from the kernel, and what the relay has dropped.
    ProgramUsage usage();
    /// The autopilot that runs already; nullopt where the lab starts the simulator.
    const std::optional<link::LinkUrl> &vehicle() const { return m_vehicle; }
    /// Description of the vehicle for a report: "the sweep's own simulator", or the link and whether its process was found.
    std::string sourceText() const;
    /// Which core each program runs on. The owner of the station places that.
    const Placement &placement() const { return m_placement; }

Q_SIGNALS:
    /// A program ended unexpectedly or could not be started.
    void ended(const skyseal::Reason &problem);

private:
    Lab(LabPrograms programs, std::optional<link::LinkUrl> vehicle, const Placement &placement);

    void launch(QProcess &process, const QString &program, const QStringList &arguments);
    void findAutopilot();
    void readPace();
    void readAgent();
    void reportEnd(QProcess &process);
    QString file(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    LabPrograms m_programs;
    const std::optional<link::LinkUrl> m_vehicle;
    Placement m_placement;
    std::optional<link::PortOwner> m_autopilot; ///< where its process was found on this machine
    QTimer m_search;                            ///< for it
    int m_searches = 0;                         ///< that are left
    QTemporaryDir m_folder;
    QProcess m_simulator, m_agent, m_relay;
    std::optional<Address> m_caller; ///< the autopilot that calls by UDP, as the agent knows it
    RelayLog m_relayLog{file("relay.log")};
    quint16 m_vehiclePort, m_relayPort, m_groundPort;
    std::optional<std::uint64_t> m_missedSends; ///< of the simulator's paced load so far
    bool m_stopping = false;
};

} // namespace skyseal::experiment
