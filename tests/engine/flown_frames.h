// All frames of a flight of the simulated copter, recorded on a simulated clock: the telemetry of all streams at 10 Hz, and its
// answers to a station that reads the parameters and commands it.
#pragma once

#include "core/base/bytes.h"
#include "tests/sim/test_station.h"

#include <set>
#include <string>
#include <vector>

namespace skyseal::test {

struct FlownFrames
{
    FlownFrames()
    {
        using namespace mavlink;
        sim::TestStation station;
        station.onFrame = [this](const Frame &frame) {
            frames.emplace_back(frame.bytes().begin(), frame.bytes().end());
            kinds.insert(frame.messageId());
            lengths.insert(frame.bytes().size());
        };
        station.run(0.1);
        RequestDataStream streams;
        streams.target_system = 1;
        streams.req_message_rate = 10;
        streams.start_stop = 1;
        station.send(streams);
        ParamRequestList parameters;
        parameters.target_system = 1;
        station.send(parameters);
        bool flies = station.takeOff(20);
        MissionRequestList mission;
        mission.target_system = 1;
        station.send(mission);
        flies = flies && station.command(MAV_CMD_REQUEST_MESSAGE, {AutopilotVersion::kId}) == MAV_RESULT_ACCEPTED
            && station.command(MAV_CMD_DO_SET_MODE, {1, 5}) == MAV_RESULT_ACCEPTED; // LOITER
        station.run(30);
        flies = flies && station.command(MAV_CMD_DO_SET_MODE, {1, 6}) == MAV_RESULT_ACCEPTED; // RTL
        station.run(60);
        if (!flies)
            qFatal("the copter refused the flight");
    }
    std::string text() const
    {
        return "a flight of " + std::to_string(frames.size()) + " frames, of " + std::to_string(kinds.size()) + " messages and "
            + std::to_string(lengths.size()) + " lengths";
    }

    std::vector<Bytes> frames;
    std::set<std::uint32_t> kinds;
    std::set<std::size_t> lengths;
};

} // namespace skyseal::test
