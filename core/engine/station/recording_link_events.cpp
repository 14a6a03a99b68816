#include "core/engine/station/recording_link_events.h"

#include "core/channel/endpoint.h"
#include "core/crypto/suite.h"
#include "core/engine/station/station_channel.h"
#include "core/link/steady_now.h"

namespace skyseal::engine {

namespace {

using Kind = tlog::LinkEvent::Kind;

tlog::LinkEvent linkEvent(Kind kind, crypto::SuiteId suite, const std::string &peer)
{
    return {kind, wallNow(), std::string(crypto::suiteInfo(suite).name), peer};
}

} // namespace

std::unique_ptr<Recorder> startRecording(const std::string &folder, const StationChannel *channel)
{
    auto recorder = std::make_unique<Recorder>(folder);
    if (!channel)
        return recorder;
    for (const channel::SessionId session : channel->endpoint().sessions()) {
        if (const auto info = channel->endpoint().sessionInfo(session))
            recorder->note(linkEvent(Kind::Sealed, info->suite, info->peerName));
    }
    return recorder;
}

void noteLinkEvent(Recorder *recorder, const StationChannel &channel, const channel::Event &event)
{
    if (!recorder)
        return;
    if (const auto *up = std::get_if<channel::SessionUp>(&event)) {
        recorder->note(linkEvent(Kind::Sealed, up->suite, up->peerName));
    } else if (const auto *done = std::get_if<channel::SwitchDone>(&event);
               done && !done->rekey && done->failure == channel::SwitchFailure::None) {
        const std::string *peer = channel.sessions.peerName(done->session);
        recorder->note(linkEvent(Kind::Switched, done->to, peer ? *peer : std::string()));
    }
}

tlog::LinkEvent plainVehicle(WallTime time, std::uint8_t systemId)
{
    return {Kind::Plain, time, std::string(crypto::suiteInfo(crypto::SuiteId::None).name), std::to_string(systemId)};
}

} // namespace skyseal::engine
