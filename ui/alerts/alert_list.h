// Alerts for the operator: derived from the station's views and events, counted, dismissed and forgotten here. No widgets and
// no clock; times are seconds on any steady clock. Bounded: at most one alert of each kind and system id.
#pragma once

#include "core/engine/common/peer_names.h"
#include "ui/alerts/alert.h"
#include "ui/alerts/limit_watch.h"
#include "ui/refusal_meter.h"
#include "ui/view_state.h"

#include <map>
#include <set>
#include <vector>

namespace skyseal::ui {

/// An ongoing alert stays while its state lasts. Dismissed, it stays away until the state has ended and begun again or has
/// become worse: more severe, or ten times the count. A momentary one goes after ten seconds, unless it is severe.
class AlertList
{
public:
    static constexpr double kShownFor = 10;   ///< seconds that a momentary alert stays
    static constexpr double kUnheardFor = 60; ///< seconds that an unknown agent stays after it was heard last
    static constexpr double kOwnCommand = 5;  ///< seconds in which a change of mode follows a command from here
    /// Seconds after which a dismissed report of the same content counts as a new one: the station repeats it each minute.
    static constexpr double kReportsRepeat = 120;

    /// Whose limits raise alerts, and the units of their texts.
    void setValues(const ValueChoices &choices, UnitSystem units);
    /// Takes the view of the station, never that of a replay. Call for each snapshot.
    void showView(const ViewState &live, double now);
    /// Takes the next event of the station.
    void handleEvent(const engine::Event &event, double now);
    /// A part of this program has sent a command that changes the mode of this vehicle.
    void noteCommand(std::uint8_t systemId, double now) { m_commands[systemId] = now; }
    /// Ends momentary alerts that are over; showView() does so as well.
    void expire(double now);
    void dismiss(AlertId id);

    /// The alerts that are not dismissed, severe ones first, then those of the selected vehicle and of
    /// none, then in the order in which they began.
    std::vector<Alert> alerts() const;
    /// The alerts that have begun, come back or become worse since the last call, at most kMostRaised.
    std::vector<Alert> takeRaised();
    static constexpr std::size_t kMostRaised = 16;
    /// True while an alert would end by time alone.
    bool hasMomentary() const;

private:
    struct Entry
    {
        Alert alert;
        double heard = 0;        ///< the last time
        std::uint64_t round = 0; ///< in which the state was seen last
        bool dismissed = false;
        AlertSeverity dismissedAs{};   ///< with this severity
        std::uint64_t dismissedAt = 0; ///< with this count
    };
    /// Attacks on one vehicle that last: what was refused since its link came up.
    struct Attack
    {
        std::uint64_t forged = 0, replayed = 0;
    };
    struct FailsafeText
    {
        QString text;
        double time = 0;
    };

    void startOver();
    void showVehicle(const engine::VehicleSnapshot &vehicle, double now);
    void showMode(const engine::VehicleSnapshot &vehicle, double now);
    void showAttacks(const engine::Snapshot &snapshot, double now);
    void showStorage(const engine::Snapshot &snapshot, double now);
    void showUnknown(const engine::Snapshot &snapshot, double now);
    void handleSwitch(const channel::SwitchDone &done, const engine::Event &event, double now);
    /// The vehicle that is heard over a session; 0 without one.
    std::uint8_t vehicleOf(channel::SessionId session) const;
    QString peerText(channel::SessionId session) const;
    /// A state that lasts, in every view again.
    void raiseState(Alert alert, double now);
    void raiseEvent(Alert alert, double now);
    void raise(AlertId id);
    QString shownText(const Alert &alert) const;

    std::map<AlertId, Entry> m_entries;
    std::vector<AlertId> m_raised;
    std::map<std::uint8_t, std::string> m_modes;
    std::map<std::uint8_t, double> m_commands; ///< time of the last one
    std::map<std::uint8_t, FailsafeText> m_failsafeTexts;
    std::set<channel::SessionId> m_notStoring; ///< agents that cannot store their counters
    RefusalMeter m_refusals;
    LimitWatch m_limits;
    UnitSystem m_units = UnitSystem::Metric;
    engine::PeerNames m_names;
    SnapshotPtr m_snapshot;
    std::uint64_t m_round = 0;
    bool m_inSweep = false;
    std::uint8_t m_selected = 0; ///< the vehicle in the window
};

} // namespace skyseal::ui
