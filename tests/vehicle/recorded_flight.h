// The state of a real autopilot at a time of its flight, from the recordings in tests/data.
#pragma once

#include "core/log/log_reader.h"
#include "vehicle_harness.h"

#include <fstream>

namespace skyseal::vehicle {

/// A vehicle that hears a recording up to this many seconds after its first frame.
class RecordedFlight
{
public:
    RecordedFlight(const QString &name, double seconds)
    {
        std::ifstream file((QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/data/recordings/") + name).toStdString(),
                           std::ios::binary);
        tlog::LogReader reader(file, mavlink::Dialect::builtin());
        std::optional<WallTime> first;
        while (const auto item = reader.next()) {
            if (!item->frame || !item->time)
                continue;
            first = first.value_or(*item->time);
            const double time = std::chrono::duration<double>(*item->time - *first).count();
            if (time > seconds)
                break;
            if (!m_vehicle)
                m_vehicle.emplace(VehicleConfig{}, item->frame->systemId(), item->frame->componentId());
            runUntil(at(time));
            m_vehicle->handleFrame(m_now, *item->time, *item->frame);
            while (m_vehicle->pollOutgoing() || m_vehicle->pollEvent()) {}
        }
        if (m_vehicle)
            runUntil(at(seconds));
    }

    std::optional<VehicleState> state() const { return m_vehicle ? std::optional(m_vehicle->state(m_now)) : std::nullopt; }

private:
    void runUntil(TimePoint end)
    {
        while (m_vehicle->nextDeadline() <= end) {
            m_now = std::max(m_now, m_vehicle->nextDeadline());
            m_vehicle->handleDeadline(m_now);
        }
        m_now = std::max(m_now, end);
    }

    TimePoint m_now{};
    std::optional<Vehicle> m_vehicle;
};

} // namespace skyseal::vehicle
