// Brings the link of a sweep into the state that a run needs, and at the end back into its own: opens and closes the station,
// orders how it carries MAVLink and under which suite, and keeps its newest snapshot. MeasuredLink says what has been reached
// by then. The caller decides when to give an order and for how long to wait. Lives on the station's thread.
#pragma once

#include "core/experiment/measured_link.h"
#include "core/experiment/suite_switch.h"
#include "core/experiment/sweep_station.h"

namespace skyseal::experiment {

class LinkDriver
{
public:
    using Snapshot = std::shared_ptr<const engine::Snapshot>;

    static constexpr int kWatching = 20; ///< snapshots a second while the link is brought into a state

    /// The parameters are those of SweepStation. `bareKey`: file of the key of bare ciphers.
    LinkDriver(engine::StationConfig config, std::optional<link::LinkUrl> link, engine::Station *borrowed,
               std::optional<int> core, std::string bareKey = {});
    /// Gives a borrowed station back.
    ~LinkDriver();

    SweepStation &station() { return m_station; }
    const SweepStation &station() const { return m_station; }
    MeasuredLink &measured() { return m_measured; }
    const MeasuredLink &measured() const { return m_measured; }
    const SuiteSwitch &suiteSwitch() const { return m_switch; }

    void take(const Snapshot &snapshot);
    /// The programs at the far end are gone, and what the newest snapshot shows with them.
    void forgetSnapshot();
    /// The newest one; null before the first of this station.
    const Snapshot &snapshot() const { return m_snapshot; }
    /// In seconds of the station's clock; 0 without a snapshot.
    double snapshotTime() const;
    /// The live session; null without one. Points into the snapshot.
    const engine::SessionSnapshot *session() const;
    bool hasVehicle() const;
    /// True if the vehicle is reached as well as heard, `inStage` seconds after it was heard first. `isFresh`: the station was
    /// just opened.
    bool isSettled(double inStage, bool isFresh) const;

    /// Opens the station, with this protection from the start if it is the sweep's own.
    Result<void, InputError> open(engine::Protection first);
    /// SweepStation::closed() follows. A link that is not known to be restored goes back to its first suite by itself.
    void close() { m_station.close(suiteToResume()); }
    /// nullopt: that of the station's settings.
    void setProtection(std::optional<engine::Protection> protection);
    /// The vehicle encrypts payloads by this cipher, or is about to; nullopt: it does not. In plain MAVLink, of a station of
    /// the sweep's own. Fails if the key file cannot be read.
    Result<void, InputError> setBareCipher(std::optional<crypto::MavsecKind> cipher);
    /// True if frames that the bare cipher does not decrypt have come since forgetUnreadable(): the vehicle does not use it.
    bool hasUnreadable() const;
    void forgetUnreadable();
    /// Of an open station, as far as it is the sweep's own.
    void setSnapshotsPerSecond(int perSecond);

    /// Begins with a new suite, to which no session has been ordered yet.
    void beginSwitch(crypto::SuiteId suite) { m_switch.begin(suite); }
    /// Sessions that come up begin with that suite.
    void holdSuite() { m_station.holdSuite(m_switch.wanted()); }
    /// Orders the switch to that suite where it is due. `now`: as for SuiteSwitch.
    void orderSwitch(double now);
    SuiteSwitch::Outcome finishSwitch(const channel::SwitchDone &done, double now);
    /// True in plain MAVLink, or if that suite is in use and no other one is pending. Needs a snapshot.
    bool isUnderSuite() const { return m_measured.isUnder(m_switch.wanted(), *m_snapshot); }

    /// Orders the protection and the suite that the link had first. False if there is nothing to restore, or no link to do that
    /// on: the station is to be closed then.
    bool beginRestoring();
    /// While restoring: takes a probe that was requested after beginRestoring().
    void takeAfterOrders(const Snapshot &snapshot);
    /// True if the link is known to be restored, or lost. Until then order the switch.
    bool isRestoringOver() const;

private:
    std::optional<crypto::SuiteId> suiteToResume() const;
    bool isRestored() const { return m_isCurrent && m_measured.isRestored(*m_snapshot); }

    SweepStation m_station;
    const std::string m_bareKey;
    MeasuredLink m_measured;
    SuiteSwitch m_switch;
    Snapshot m_snapshot;
    std::uint64_t m_unreadableBefore = 0;
    bool m_isCurrent = false; ///< while restoring: the snapshot was taken after the orders
};

} // namespace skyseal::experiment
