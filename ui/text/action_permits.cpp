#include "ui/text/action_permits.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "core/vehicle/command_plan.h"
#include "core/vehicle/flight_modes.h"
#include "core/vehicle/flight_rules.h"
#include "ui/text/command_permits.h"
#include "ui/text/vehicle_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct ActionPermitsText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ActionPermits)
};

/// The reasons of the window. Commands without a row have none: those that make a flight safer, as Land, RTL and the emergency
/// stop, must not depend on a state that anybody on a plain link may claim, or a confused autopilot.
class Reasons
{
public:
    explicit Reasons(const ViewState &view)
        : m_view(view), m_vehicle(*view.vehicle), m_kind{m_vehicle.state.type, m_vehicle.state.autopilot}
    {}

    template<typename Command> QString operator()(const Command &) const { return {}; }
    QString operator()(const vehicle::Arm &) const
    {
        return heard() && m_vehicle.state.armed ? ActionPermitsText::tr("the vehicle is armed") : QString();
    }

    /// The emergency stop does not depend on it.
    QString operator()(const vehicle::Disarm &order) const
    {
        if (order.force)
            return {};
        const bool flew = m_vehicle.state.inAir && vehicle::rulesOf(m_vehicle.state).flies;
        return flew && !heard() ? wasFlying() : disarmed();
    }

    QString operator()(const vehicle::TakeOff &) const
    {
        if (m_vehicle.state.inAir)
            return heard() ? ActionPermitsText::tr("the vehicle is already flying") : wasFlying();
        return notHeard();
    }
    QString operator()(const vehicle::Loiter &) const { return movesDisabledReason(m_view); }
    QString operator()(const vehicle::ChangeAltitude &) const { return climbsDisabledReason(m_view); }

    QString operator()(const vehicle::StartMission &) const
    {
        const std::size_t home = m_kind.isArduPilot() ? 1 : 0; // ArduPilot's item 0
        if (m_vehicle.mission && m_vehicle.mission->size() <= home)
            return ActionPermitsText::tr("the mission last read is empty: read it again");
        return notHeard();
    }

private:
    bool heard() const { return m_vehicle.state.heartbeatAge <= m_vehicle.state.staleAfter; }
    /// What begins a flight would begin one that nobody sees.
    QString notHeard() const { return heard() ? QString() : ActionPermitsText::tr("the vehicle is not heard"); }
    static QString wasFlying() { return ActionPermitsText::tr("the vehicle was flying when it was last heard"); }
    QString disarmed() const
    {
        return heard() && !m_vehicle.state.armed ? ActionPermitsText::tr("the vehicle is disarmed") : QString();
    }

    const ViewState &m_view;
    const engine::VehicleSnapshot &m_vehicle;
    vehicle::VehicleKind m_kind;
};

} // namespace

QString actionDisabledReason(const vehicle::VehicleCommand &command, const ViewState &view)
{
    const QString nothing = commandsDisabledReason(view);
    if (!nothing.isEmpty())
        return nothingCanBeSent(nothing);
    QString reason = std::visit(Reasons(view), command);
    if (reason.isEmpty()) {
        // Commands that the client would refuse to send: take-off in another mode, and commands that the vehicle lacks.
        if (const auto plan = vehicle::planCommand(command, view.vehicle->state, {}); !plan)
            reason = reasonText(plan.error());
    }
    return reason.isEmpty() ? QString() : ActionPermitsText::tr("Not now: %1").arg(reason);
}

} // namespace skyseal::ui
