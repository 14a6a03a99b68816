// Publishes the vehicles of a station to a broker: the state of each twice a second, its events as they occur, and, if
// requested, its MAVLink frames. Topics are in core/mqtt/topics.h; an event has the JSON of the monitor.
//
// takeFrame() and status() are called on the I/O thread, the rest on the thread of the Station object.
#pragma once

#include "core/engine/common/peer_names.h"
#include "core/engine/station/event.h"
#include "core/engine/station/feed.h"
#include "core/mqtt/message_sink.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace skyseal::engine {

struct Snapshot;

class FleetFeed final : public Feed
{
public:
    /// Seconds between two states of a vehicle.
    static constexpr double kStateEvery = 0.5;

    /// `raw`: publish the frames, too.
    FleetFeed(std::unique_ptr<mqtt::MessageSink> sink, bool raw) : m_sink(std::move(sink)), m_raw(raw) {}

    /// Call for every snapshot; only some are published.
    void take(const Snapshot &snapshot, WallTime now);
    /// Call for every event.
    void handleEvent(const Event &event);

    void takeFrame(ByteView frame) override;
    mqtt::PublisherStatus status() const override { return m_sink->status(); }

private:
    std::vector<std::uint8_t> vehiclesOf(const Event &event) const;
    std::vector<std::uint8_t> vehiclesOver(channel::SessionId session) const;

    const std::unique_ptr<mqtt::MessageSink> m_sink;
    const bool m_raw;
    PeerNames m_names;
    std::map<std::uint8_t, std::optional<channel::SessionId>> m_vehicles; ///< and their sessions, by the newest snapshot
    double m_nextState = 0;                                               ///< seconds since the station started
};

} // namespace skyseal::engine
