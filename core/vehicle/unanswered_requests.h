// The requests to a vehicle that have no result yet, so that each ends when the component to which it went turns out not to be
// the autopilot.
#pragma once

#include "core/vehicle/event.h"
#include "core/vehicle/request.h"

#include <deque>
#include <map>

namespace skyseal::vehicle {

class UnansweredRequests
{
public:
    /// A client has accepted the request.
    void note(RequestId id, std::uint8_t systemId, const Request &request);
    /// Takes an event of the vehicle, which may be the result of a request.
    void handle(const Event &event);
    /// Appends a failed result of each request to `events`, and forgets all.
    void fail(std::deque<Event> &events);

private:
    std::map<RequestId, Event> m_failures; ///< the result that each gets if it fails
};

} // namespace skyseal::vehicle
