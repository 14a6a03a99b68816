// Sends commands to the selected vehicle and reports the results as text ("Arm: denied: …"). Shared by the action bar and the
// menus. Lives on the GUI thread.
#pragma once

#include "ui/flight/preflight.h"
#include "ui/settings.h"
#include "ui/view_state.h"

#include <QtCore/QHash>
#include <QtCore/QObject>
#include <QtCore/QString>

namespace skyseal::ui {

class VehicleCommands : public QObject
{
    Q_OBJECT

public:
    explicit VehicleCommands(StationInterface &station, QObject *parent = nullptr);

    void showViewState(const ViewState &view);
    /// Returns the reason why commands cannot be sent; empty if they can.
    const QString &disabledReason() const { return m_disabledReason; }
    /// Returns the reason, in a sentence, why `command` makes no sense for the selected vehicle now; empty if it does.
    QString disabledReason(const vehicle::VehicleCommand &command) const;
    /// True if `command` arms the selected vehicle on its way, so that it is named and asked like arming.
    bool armsFirst(const vehicle::VehicleCommand &command) const;
    /// True if arming the selected vehicle in its present mode begins a flight at once.
    bool armingTakesOff() const;
    /// System id of the selected vehicle; 0 without one.
    std::uint8_t systemId() const { return m_systemId; }
    /// True if there are several vehicles, so that a question must name the vehicle.
    bool isOneOfSeveral() const { return m_severalVehicles; }
    /// Sends the command to `systemId`. Refused, with a report, if commands cannot be sent or if another vehicle has been
    /// selected since the operator confirmed, because its result would not be visible.
    void send(std::uint8_t systemId, const vehicle::VehicleCommand &command);
    /// The mission of the selected vehicle as it was read or written last; null if it is not known.
    const vehicle::MissionItems &mission() const { return m_mission; }
    /// Why the vehicle may have another mission by now; empty while there is no sign of it.
    const QString &missionOutdated() const { return m_missionOutdated; }
    /// Sends that mission with a further waypoint (degrees, metres above home), by the same rules as send(), and only over the
    /// mission that it was made from.
    void addWaypoint(std::uint8_t systemId, double latitude, double longitude, float altitude);
    void handleEvent(const engine::Event &event);

    /// The checklists of the vehicles; see sendOrAsk().
    Preflight &preflight() { return m_preflight; }

    /// Altitude of the next take-off in metres above home, shared by bar and menu.
    double takeOffAltitude() const { return m_takeOffAltitude; }
    void setTakeOffAltitude(double metres);

    /// In which the names of commands give altitudes.
    UnitSystem units() const { return m_units; }
    void setUnits(UnitSystem units) { m_units = units; }

Q_SIGNALS:
    void takeOffAltitudeChanged(double metres);
    /// The vehicle or its state may have changed, and with it the reasons against commands.
    void permitsChanged();
    /// A command has been sent; commandEnded() follows with its answer.
    void commandSent(std::uint8_t systemId, skyseal::vehicle::RequestId id, const skyseal::vehicle::VehicleCommand &command);
    void commandEnded(skyseal::vehicle::RequestId id, skyseal::vehicle::CommandOutcome outcome);
    /// One line for the operator; `ok` is false if the vehicle refused or did not answer.
    void resultReported(const QString &line, bool ok);

private:
    /// False, with a report, if nothing can be sent to `systemId`.
    bool maySend(std::uint8_t systemId, const QString &text);
    void request(std::uint8_t systemId, vehicle::Request request, const QString &text);
    void reportResult(vehicle::RequestId id, const QString &outcome, bool ok);

    StationInterface &m_station;
    ViewState m_view;
    Preflight m_preflight;
    std::uint8_t m_systemId = 0;
    bool m_severalVehicles = false;
    vehicle::MissionItems m_mission;
    QString m_missionOutdated;
    std::optional<vehicle::MissionItem> m_home; ///< item 0 of a mission that is empty so far, if home belongs there
    QString m_disabledReason;
    double m_takeOffAltitude = 10;
    UnitSystem m_units = UnitSystem::Metric;
    QHash<quint32, QString> m_asked;
};

} // namespace skyseal::ui
