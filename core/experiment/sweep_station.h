// The station that a sweep measures on: its own one, created for each block of runs, or one that is borrowed from the
// window. A borrowed station keeps its links, its vehicles and the pace of its snapshots, and carries MAVLink as before when it
// is given back. Lives on the station's thread.
#pragma once

#include "core/engine/station/station.h"

#include <memory>
#include <optional>
#include <utility>

namespace skyseal::experiment {

class SweepStation : public QObject
{
    Q_OBJECT

public:
    /// With `borrowed`, `config` and `link` are not used; without it, `link` must have a value.
    /// `core`: on which the threads of an own station run; nullopt: left to the system.
    SweepStation(engine::StationConfig config, std::optional<link::LinkUrl> link, engine::Station *borrowed,
                 std::optional<int> core);

    bool isOpen() const { return m_station != nullptr; }
    bool isBorrowed() const { return m_borrowed != nullptr; }
    /// Takes the borrowed station, or creates one with this protection from the start.
    Result<void, InputError> open(engine::Protection first);
    /// closed() follows. `resume`: the suite to which the next session of a borrowed station switches.
    void close(std::optional<crypto::SuiteId> resume);
    /// Gives a borrowed station back at once, without closed().
    void giveBack(std::optional<crypto::SuiteId> resume);

    /// These eight need an open station.
    /// Requests a reading of all counters, which comes as probeTaken().
    void requestProbe() { m_station->requestProbe(); }
    vehicle::RequestId perform(std::uint8_t systemId, vehicle::Request request)
    {
        return m_station->perform(systemId, std::move(request));
    }
    /// While true, the agent's reports have its costs, which are part of the traffic then.
    void requestCosts(bool request) { m_station->requestCosts(request); }
    /// Of the sweep's own station; a borrowed one keeps its pace.
    void setSnapshotsPerSecond(int perSecond);
    /// Ends holdSuite(): the switch to the suite of a run is measured as well.
    void setProtection(std::optional<engine::Protection> protection);
    void setBareCipher(std::optional<crypto::MavsecCipher> cipher);
    /// Sessions that come up begin with this suite.
    void holdSuite(crypto::SuiteId suite) { m_station->holdSuite(suite); }
    void switchSuite(channel::SessionId session, crypto::SuiteId suite) { m_station->switchSuite(session, suite); }

Q_SIGNALS:
    void snapshotReady(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    void probeTaken(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    void eventOccurred(skyseal::engine::Event event);
    void closed();
    /// The borrowed station was destroyed while it was in use.
    void lost();

private:
    void listen();

    const engine::StationConfig m_config;
    const std::optional<link::LinkUrl> m_link;
    engine::Station *m_borrowed;
    const std::optional<int> m_core;
    std::unique_ptr<engine::Station> m_own;
    engine::Station *m_station = nullptr; ///< one of the two while it is in use
};

} // namespace skyseal::experiment
