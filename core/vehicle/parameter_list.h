// The list of one component's parameters on its way: PARAM_REQUEST_LIST, whose answers bring their number, and requests by
// index for those that are lost, while the others still arrive (RequestWindow). No I/O and no clock.
// https://mavlink.io/en/services/parameter.html
#pragma once

#include "core/base/reason.h"
#include "core/vehicle/request_window.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace skyseal::vehicle {

class ParameterList
{
public:
    /// Without an answer for so long, the list is requested again; with a single one, it has ended.
    static constexpr Duration kListTimeout = std::chrono::seconds(1);
    /// A parameter is lost when so many later ones arrived: datagrams overtake each other.
    static constexpr std::size_t kReordered = 8;
    /// The list has ended when nothing came for several of its intervals, and at least for so long.
    static constexpr Duration kLeastPause = std::chrono::milliseconds(50);
    /// What poll() returns for the whole list, in place of an index.
    static constexpr int kWhole = -1;

    /// Begins the list. It fails when no new parameter came for `patience`. It is requested from `request` on: at once, or
    /// later if a broadcast has requested it.
    void begin(TimePoint now, Duration patience, TimePoint request);
    /// Ends it as it is.
    void end() { m_giveUp = m_requestDue = kNever; }
    bool isReading() const { return m_giveUp != kNever; }

    /// A parameter with its place in the list. Also counts while no list is read.
    void arrived(TimePoint now, std::uint16_t index, std::uint16_t count);
    /// The component has refused a parameter by its index. Without a request for it, nothing happens.
    void refused(TimePoint now, std::uint16_t index, const Reason &reason);
    /// Ends the list if nothing new came for too long.
    void handleDeadline(TimePoint now);

    /// The next index to request now, or kWhole; nullopt if nothing is due.
    std::optional<int> poll(TimePoint now);
    TimePoint nextDeadline() const;

    /// Every parameter has arrived.
    bool isComplete() const { return m_window.isComplete() && m_refused.empty(); }
    std::size_t received() const { return m_window.received() - m_refused.size(); }
    std::size_t count() const { return m_window.count(); }
    /// Why the component refused a parameter; empty if it did not.
    const Reason &refusal() const { return m_refusal; }
    RttEstimator &rtt() { return m_window.rtt(); }
    const RttEstimator &rtt() const { return m_window.rtt(); }

private:
    void noteInterval(TimePoint now);

    RequestWindow m_window;                 ///< of the list in progress, or the latest one
    std::size_t m_reached = 0;              ///< the list has come this far
    std::vector<std::uint16_t> m_refused{}; ///< indexes, which m_window counts as received
    Reason m_refusal{};                     ///< of the latest one
    TimePoint m_latest{};                   ///< arrival of the latest value
    Duration m_interval{};                  ///< between values of the list: the mean and its variation, as of round trips
    Duration m_variation{};
    Duration m_patience{};
    TimePoint m_requestDue = kNever; ///< the list has paused, or is not answered
    TimePoint m_giveUp = kNever;     ///< kNever while nothing is read
};

} // namespace skyseal::vehicle
