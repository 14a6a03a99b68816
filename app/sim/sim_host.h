// Connects simulated vehicles with a clock and links; all vehicles share all links.
#pragma once

#include "app/sim/sent_framing.h"
#include "app/sim/sim_link.h"
#include "app/sim/stdin_lines.h"
#include "core/sim/pacer.h"
#include "core/sim/saturator.h"
#include "core/sim/simulated_vehicle.h"

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include <memory>
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
    bool readsStdin = false;     ///< the framing of sent messages follows lines on standard input
    bool json = false;
};

class SimHost : public QObject
{
    Q_OBJECT

public:
    SimHost(const SimSettings &settings, SentFraming framing);

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
    void takeLine(const QByteArray &line);
    void reportFraming() const;

    const SimSettings m_settings;
    std::vector<sim::SimulatedVehicle> m_vehicles;
    std::vector<std::unique_ptr<SimLink>> m_links;
    sim::Saturator m_saturator;
    std::optional<sim::Pacer> m_pacer; ///< from the first frame of a station on
    TimePoint m_paceReported{};
    QTimer m_timer;
    SentFraming m_framing;
    std::unique_ptr<StdinLines> m_stdin; ///< null unless it is read
};

} // namespace skyseal::app
