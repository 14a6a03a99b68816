// The MAVLink version in which a vehicle is spoken to: that of the frames that it sends. An autopilot that knows version 1
// alone drops every frame of version 2 without a word, and version 1 has no place for message ids above 255, for extension
// fields (the type of a plan among them) and for signatures.
// https://mavlink.io/en/guide/mavlink_version.html
#pragma once

#include "core/base/clock.h"
#include "core/base/reason.h"
#include "core/vehicle/request.h"

namespace skyseal::vehicle {

class ProtocolVersion
{
public:
    /// A vehicle that has sent version 2 speaks version 1 again after so long without it: it has restarted with other settings.
    /// An answer in version 2 among frames of version 1 (PX4's PROTOCOL_VERSION) counts until then.
    static constexpr Duration kBack = std::chrono::seconds(5);

    /// Takes the version of a frame of the autopilot.
    void handleFrame(TimePoint now, int version)
    {
        if (version == 2)
            m_newest = now;
        if (version == 2 || m_newest == kNever || now - m_newest >= kBack)
            m_version = version;
    }
    /// 2 before the first frame.
    int version() const { return m_version; }

private:
    int m_version = 2;
    TimePoint m_newest = kNever; ///< frame of version 2
};

/// Why version 1 cannot carry the request; empty if it can.
Reason unfitForVersion1(const Request &request);

} // namespace skyseal::vehicle
