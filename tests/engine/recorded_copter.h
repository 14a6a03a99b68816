// A recording of a simulated copter, made on a simulated clock: it takes off in GUIDED, hovers in LOITER, is not heard for
// half a minute, and returns.
#pragma once

#include "tests/log/recordings.h"
#include "tests/sim/test_station.h"

namespace skyseal::test {

struct RecordedCopter
{
    /// The time that the flight is not heard.
    static constexpr Duration kGapFrom = std::chrono::seconds(45), kGapTo = std::chrono::seconds(75);
    static constexpr Duration kLength = std::chrono::seconds(100);

    RecordedCopter()
    {
        sim::TestStation station;
        station.onFrame = [&](const mavlink::Frame &frame) {
            const Duration at = station.now.time_since_epoch();
            if (at >= kGapFrom && at <= kGapTo)
                return;
            const auto since = std::chrono::floor<std::chrono::microseconds>(at);
            content += tlog::entry(tlog::kNoon + since, std::string(asText(frame.bytes())));
        };
        station.run(0.1);
        mavlink::RequestDataStream streams;
        streams.target_system = 1;
        streams.req_message_rate = 10;
        streams.start_stop = 1;
        station.send(streams);
        flies = station.takeOff(10);
        station.run(25);
        content += "damage in the middle of the flight";
        station.run(10);
        flies = flies && station.command(mavlink::MAV_CMD_DO_SET_MODE, {1, 5}) == mavlink::MAV_RESULT_ACCEPTED;
        station.run(seconds(kLength - station.now.time_since_epoch()) - 20);
        flies = flies && station.command(mavlink::MAV_CMD_DO_SET_MODE, {1, 6}) == mavlink::MAV_RESULT_ACCEPTED;
        station.run(20);
    }

    bool flies = false; ///< all went as described
    std::string content;
};

} // namespace skyseal::test
