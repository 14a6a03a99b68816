// Flies the vehicle of the demo: take-off, then rounds of a square. Ends with the first command of the operator.
#pragma once

#include "core/vehicle/flight_script_runner.h"
#include "ui/station_interface.h"

#include <optional>

namespace skyseal::engine {
struct Snapshot;
}

namespace skyseal::app {

class DemoFlight : public QObject
{
    Q_OBJECT

public:
    /// `station` must outlive this.
    explicit DemoFlight(ui::StationInterface &station);

private:
    void advance(const engine::Snapshot &snapshot);
    void handleResult(const vehicle::CommandResult &result);
    void sendRequests();

    ui::StationInterface &m_station;
    std::optional<vehicle::FlightScriptRunner> m_script; ///< empty after a command of the operator
    std::optional<vehicle::RequestId> m_lastRequest;
};

} // namespace skyseal::app
