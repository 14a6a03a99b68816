// Collects the reasons for which the autopilot would not arm, from its status texts. ArduPilot says "PreArm: …" every 30 s
// while a check fails and at a refused attempt, and "Arm: …" at an attempt that another check refuses
// (AP_Arming::check_failed); PX4 says "Preflight Fail: …" and "Arming denied: …".
#pragma once

#include "core/base/clock.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

class PreArmReasons
{
public:
    /// A reason that is not repeated for this long no longer counts.
    static constexpr Duration kKept = std::chrono::seconds(40);
    /// The reason that was said longest ago gives way to another one.
    static constexpr std::size_t kMost = 16;

    /// `text`: any status text of the autopilot; others than those above are ignored.
    void handleText(TimePoint now, std::string_view text);
    /// Drops all reasons: the vehicle has been armed, or reports that its checks pass.
    void clear() { m_reasons.clear(); }
    /// Those that count, without "PreArm: ", in the order in which they were first said; each text once.
    std::vector<std::string> at(TimePoint now) const;

private:
    struct Reason
    {
        std::string text;
        TimePoint said{}; ///< the last time
        bool countsAt(TimePoint now) const { return now - said < kKept; }
    };

    std::vector<Reason> m_reasons;
};

} // namespace skyseal::vehicle
