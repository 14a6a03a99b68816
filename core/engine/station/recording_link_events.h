// Tells the recorder the cipher suites of the station's sessions, and which vehicles have none. I/O thread.
#pragma once

#include "core/channel/events.h"
#include "core/engine/station/recorder.h"

#include <memory>
#include <string>

namespace skyseal::engine {

struct StationChannel;

/// A recorder that knows the suites of the sessions that are up. `channel` is null without keys.
std::unique_ptr<Recorder> startRecording(const std::string &folder, const StationChannel *channel);

/// Notes a session that came up, or that switched its suite; ignores all other events. Call before the session is forgotten;
/// `recorder` is null while nothing is recorded.
void noteLinkEvent(Recorder *recorder, const StationChannel &channel, const channel::Event &event);

/// The event of a vehicle that was heard in plain MAVLink.
tlog::LinkEvent plainVehicle(WallTime time, std::uint8_t systemId);

} // namespace skyseal::engine
