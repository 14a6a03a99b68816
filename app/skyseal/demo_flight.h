// Flies the demo's vehicle, so that there is something to see: take-off, then rounds of a square. The first command of the
// operator's own takes over.
#pragma once

#include "core/vehicle/flight_script_runner.h"
#include "ui/station_interface.h"

#include <optional>

namespace skyseal::app {

class DemoFlight : public QObject
{
    Q_OBJECT

public:
    /// `station` must outlive it.
    explicit DemoFlight(ui::StationInterface &station);

private:
    void advance(const engine::Snapshot &snapshot);
    void hear(const vehicle::CommandResult &result);
    void sendOrders();

    ui::StationInterface &m_station;
    std::optional<vehicle::FlightScriptRunner> m_script; ///< empty once the operator flies
    std::optional<vehicle::CommandId> m_ours;
};

} // namespace skyseal::app
