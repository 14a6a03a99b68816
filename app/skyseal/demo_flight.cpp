#include "app/skyseal/demo_flight.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/link/steady_now.h"
#include "core/vehicle/flight_script.h"

#include <string>

namespace skyseal::app {

namespace {

constexpr int kRounds = 20;

/// A square of about 60 m north-east of where skyseal-sim starts.
std::string script()
{
    std::string out = "wait ekf_ok==1 60; mode GUIDED; arm; takeoff 20; wait alt_rel>=18 60";
    for (int round = 0; round < kRounds; ++round) {
        out += "; goto -35.362721 149.165230 20; sleep 16; goto -35.362721 149.165890 20; sleep 16"
               "; goto -35.363261 149.165890 20; sleep 16; goto -35.363261 149.165230 20; sleep 16";
    }
    return out;
}

} // namespace

DemoFlight::DemoFlight(ui::StationInterface &station)
    : m_station(station), m_script(vehicle::parseFlightScript(script()).value())
{
    connect(&m_station, &ui::StationInterface::snapshotReady, this,
            [this](const ui::SnapshotPtr &snapshot) { advance(*snapshot); });
    connect(&m_station, &ui::StationInterface::eventOccurred, this, [this](const engine::Event &event) {
        if (const auto *result = std::get_if<vehicle::CommandResult>(&event))
            handleResult(*result);
    });
}

void DemoFlight::advance(const engine::Snapshot &snapshot)
{
    if (!m_script)
        return;
    std::vector<const vehicle::VehicleState *> vehicles;
    for (const engine::VehicleSnapshot &vehicle : snapshot.vehicles)
        vehicles.push_back(&vehicle.state);
    m_script->advance(steadyNow(), vehicles);
    sendRequests();
}

void DemoFlight::handleResult(const vehicle::CommandResult &result)
{
    if (!m_script)
        return;
    if (result.id != m_lastRequest) {
        m_script.reset();
        return;
    }
    m_script->handleResult(result);
    sendRequests();
}

void DemoFlight::sendRequests()
{
    while (auto next = m_script->pollRequest()) {
        m_lastRequest = m_station.perform(next->systemId, std::move(next->request));
        m_script->requestSent(*m_lastRequest);
    }
    while (m_script->pollReport()) {} // the window itself shows the result of each command
}

} // namespace skyseal::app

#include "moc_demo_flight.cpp"
