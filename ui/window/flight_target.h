// The place that the operator has sent the selected vehicle to, which the map marks until the vehicle is there, another command
// takes its place, or the vehicle leaves the mode in which it flies to places. Lives on the GUI thread.
#pragma once

#include "core/vehicle/request_id.h"
#include "core/vehicle/vehicle_command.h"
#include "ui/view_state.h"

#include <QtCore/QObject>

#include <optional>

namespace skyseal::vehicle {
struct VehicleState;
}

namespace skyseal::ui {

class MapView;
class VehicleCommands;
class ViewSelection;

/// The mode in which the vehicle flies to places; empty if that is no mode of its own.
QString modeOfTargets(const vehicle::VehicleState &state);

class FlightTarget : public QObject
{
    Q_OBJECT

public:
    /// All must outlive this; the map becomes its parent.
    FlightTarget(MapView &map, const ViewSelection &selection, VehicleCommands &commands);

private:
    struct Target
    {
        std::uint8_t systemId = 0;
        vehicle::RequestId id{};
        vehicle::GoTo place;
        bool entered = false; ///< the mode of targets
    };

    void handleSent(std::uint8_t systemId, vehicle::RequestId id, const vehicle::VehicleCommand &command);
    void follow(const ViewState &live);
    bool isOver(const vehicle::VehicleState &state);
    void show(const ViewState &view);

    MapView &m_map;
    const ViewSelection &m_selection;
    std::optional<Target> m_target;
};

} // namespace skyseal::ui
