// Passes each frame addressed to the vehicle to the server of its micro-protocol; answers PING and TIMESYNC itself.
#pragma once

#include "core/sim/command_server.h"
#include "core/sim/control_server.h"
#include "core/sim/ftp_server.h"
#include "core/sim/gcs_watch.h"
#include "core/sim/log_server.h"
#include "core/sim/mission_server.h"
#include "core/sim/parameter_server.h"

namespace skyseal::sim {

struct FrameRouter
{
    Autopilot &autopilot;
    FrameQueue &outbox;
    StreamScheduler &streams;
    CommandServer &commands;
    ControlServer &control;
    MissionServer &missions;
    ParameterServer &parameters;
    LogServer &logs;
    FtpServer &ftp;
    GcsWatch &station;
    TimePoint boot;
    std::uint8_t systemId;

    void route(TimePoint now, const mavlink::Frame &frame) const;

private:
    bool isForUs(const mavlink::Frame &frame) const;
    bool routeMission(TimePoint now, const FrameSender &peer, const mavlink::Frame &frame) const;
    bool routeParameter(TimePoint now, const mavlink::Frame &frame) const;
    bool routeFile(TimePoint now, const FrameSender &peer, const mavlink::Frame &frame) const;
    bool routeCommand(TimePoint now, const FrameSender &peer, const mavlink::Frame &frame) const;
    bool routeLink(TimePoint now, const FrameSender &peer, const mavlink::Frame &frame) const;
    /// An item outside a mission, by its `current` field: 2 = fly there, 3 = change height.
    void flyTo(const FrameSender &peer, const StoredItem &item, std::uint8_t kind) const;
};

} // namespace skyseal::sim
