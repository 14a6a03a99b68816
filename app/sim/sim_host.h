// Connects simulated vehicles with a clock and links; all vehicles share all links.
#pragma once

#include "app/sim/sim_link.h"
#include "core/sim/pacer.h"
#include "core/sim/saturator.h"
#include "core/sim/simulated_vehicle.h"

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include <optional>

namespace skyseal::app {

struct SimSettings
{
    std::vector<link::LinkUrl> links;
    int vehicles = 1;
    int systemId = 1; ///< of the first; the others follow
    std::uint64_t seed = 1;
    double rate = 1;
    sim::VehicleType type;
    std::size_t trustedLink = 0; ///< number of the link that is trusted as a USB port is, from 1; 0 = none
    bool saturate = false;       ///< telemetry as fast as the station responds
    std::uint32_t perSecond = 0; ///< telemetry messages besides the streams, on a schedule; 0 = none
    bool json = false;
};

class SimHost : public QObject
{
    Q_OBJECT

public:
    explicit SimHost(const SimSettings &settings);

    /// Opens the links; emits failed() if one cannot be opened.
    void start();

Q_SIGNALS:
    void failed();

private:
    void makeVehicles(TimePoint now);
    void received(TimePoint time, const mavlink::Frame &frame, sim::LinkTrust trust);
    void live();
    void pace(TimePoint now);
    std::uint64_t dropped() const;
    void reportPace(TimePoint now);
    void send(TimePoint now);
    void report(link::Link &link);

    const SimSettings m_settings;
    std::vector<sim::SimulatedVehicle> m_vehicles;
    std::vector<std::unique_ptr<SimLink>> m_links;
    sim::Saturator m_saturator;
    std::optional<sim::Pacer> m_pacer; ///< from the first frame of a station on
    TimePoint m_paceReported{};
    QTimer m_timer;
};

} // namespace skyseal::app
