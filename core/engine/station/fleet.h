// The vehicles that a station knows, and the statistics of its accepted frames: sequence loss, the inspector's table, the
// chosen fields and the watches of each vehicle. I/O thread; no I/O itself.
#pragma once

#include "core/engine/common/totals.h"
#include "core/engine/station/event.h"
#include "core/engine/station/field_table.h"
#include "core/engine/station/inspector_table.h"
#include "core/engine/station/message_counts.h"
#include "core/engine/station/station_config.h"
#include "core/engine/station/text_copies.h"
#include "core/engine/station/vehicle_watches.h"
#include "core/vehicle/vehicle_set.h"

#include <array>
#include <optional>

namespace skyseal::engine {

class Fleet
{
public:
    explicit Fleet(const StationConfig &config);

    /// Takes an accepted frame; `session` is empty for a clear one. Returns an event if it makes a vehicle known,
    /// or the autopilot of a known one.
    std::optional<VehicleFound> take(TimePoint now, WallTime wall, const Path &from, const mavlink::Frame &frame,
                                     std::optional<channel::SessionId> session);
    /// Takes an accepted frame that is not the newest of its kind any more, see FrameOrder.
    void takeLate(TimePoint now, const Path &from, const mavlink::Frame &frame);
    /// Takes the state of a radio, which inserts RADIO_STATUS with a system id of its own. It is that of the vehicles that are
    /// heard over this session, or in clear from the same address.
    void takeRadioStatus(const Path &from, const mavlink::Frame &frame, std::optional<channel::SessionId> session);

    /// Null if the vehicle is not known.
    vehicle::Vehicle *find(std::uint8_t systemId) { return m_vehicles.find(systemId); }
    /// Forgets a vehicle that is lost. Returns false if it is not, or not known.
    bool forget(TimePoint now, std::uint8_t systemId);
    vehicle::VehicleSet &vehicles() { return m_vehicles; }
    const vehicle::VehicleSet &vehicles() const { return m_vehicles; }
    VehicleWatches &watches() { return m_watches; }
    const VehicleWatches &watches() const { return m_watches; }
    InspectorTable &inspector() { return m_inspector; }
    const InspectorTable &inspector() const { return m_inspector; }
    const MessageCounts &messages() const { return m_messages; }
    FieldTable &fields() { return m_fields; }
    const FieldTable &fields() const { return m_fields; }

    /// Publishes the events of a vehicle. `sealed`: its frames arrive over a session.
    static void publishEvents(vehicle::Vehicle &vehicle, bool sealed, const Notify &notify);

    /// Call four times a second: publishes vehicles that are lost or back. Returns true if at least one is
    /// present: not lost, and its session has not ended.
    bool sample(TimePoint now, const Notify &notify);
    /// Round-trip time in seconds of the vehicle heard last; vehicle::kUnknown without one.
    double latency(TimePoint now) const;
    /// Sums over all accepted frames; bad checksums are counted by the links.
    MavlinkTotals totals() const;
    /// Of them those that arrived in clear.
    MavlinkTotals clearTotals() const { return m_clear.totals(); }
    /// Of them those that were opened from records, of the vehicles that are heard over this session. Contains frames of their
    /// earlier sessions, so that only its growth tells of this one.
    MavlinkTotals sealedTotals(channel::SessionId session) const;
    VehicleSnapshot describe(TimePoint now, const vehicle::Vehicle &vehicle) const;

private:
    /// Frames of one kind by their senders.
    struct Received
    {
        void note(const metrics::SequenceTable::Sender &sender, const mavlink::Frame &frame, TimePoint now);
        MavlinkTotals totals() const;
        /// Of one system; without what concerns all senders.
        MavlinkTotals totalsOf(std::uint8_t systemId) const;

        metrics::SequenceTable sequences;
        std::array<std::uint64_t, 256> bytes{}; ///< by system
    };

    metrics::SequenceCounts countsOf(std::uint8_t systemId) const;

    vehicle::VehicleSet m_vehicles;
    VehicleWatches m_watches;
    TextCopies m_copies;
    Received m_sealed, m_clear;
    InspectorTable m_inspector;
    MessageCounts m_messages;
    FieldTable m_fields;
};

} // namespace skyseal::engine
