#include "app/common/event_text.h"

#include "app/common/format.h"
#include "app/common/overloaded.h"
#include "core/keys/public_key_text.h"
#include "core/link/address_text.h"

namespace skyseal::app {

namespace {

const char *whyDown(channel::DownReason reason)
{
    switch (reason) {
    case channel::DownReason::PeerRestarted: return "it restarted";
    case channel::DownReason::PeerClosed: return "it said goodbye";
    case channel::DownReason::TimedOut: return "it was silent too long";
    case channel::DownReason::Exhausted: return "its keys were used up";
    case channel::DownReason::Revoked: return "its key is no longer trusted";
    case channel::DownReason::Closed: return "closed here";
    }
    return "";
}

const char *whyRolledBack(channel::SwitchFailure failure)
{
    switch (failure) {
    case channel::SwitchFailure::None: return "";
    case channel::SwitchFailure::NotAllowedHere: return "not allowed here";
    case channel::SwitchFailure::NotAllowedByPeer: return "not allowed by the other end";
    case channel::SwitchFailure::NotConfirmed: return "not confirmed in time";
    case channel::SwitchFailure::Superseded: return "another switch was agreed first";
    case channel::SwitchFailure::SessionEnded: return "the session ended";
    }
    return "";
}

const char *whyRefused(channel::RefusalReason reason)
{
    switch (reason) {
    case channel::RefusalReason::UnknownPeer: return "its key is not among the known peers";
    case channel::RefusalReason::WrongKey: return "it is not meant for our key";
    case channel::RefusalReason::ReplayedHandshake:
        return "it is a replay of an old one, or the station lost its counters and is told where to go on";
    case channel::RefusalReason::CounterBehind:
        return "our counters file was lost or put back; going on from the number that the other end remembers";
    case channel::RefusalReason::CountersUsedUp: return "all handshake counters of our key are used; make a new key";
    case channel::RefusalReason::NoCommonSuite: return "there is no suite that both ends allow";
    case channel::RefusalReason::OfferTampered: return "its offer was changed on the way";
    case channel::RefusalReason::Version: return "it speaks another version";
    case channel::RefusalReason::Flood: return "there are too many; who answers a cookie gets through";
    }
    return "";
}

} // namespace

std::string suiteText(crypto::SuiteId suite)
{
    const crypto::SuiteInfo &info = crypto::suiteInfo(suite);
    return std::string(info.displayName) + (info.research ? " (insecure)" : "");
}

std::string linkText(const engine::LinkSnapshot &link)
{
    if (!link.problem.empty())
        return link.url + ": " + link.problem;
    if (link.phase == engine::LinkPhase::Listening)
        return "listening on " + link.localAddress;
    if (link.phase == engine::LinkPhase::Connected)
        return "connected: " + link.url;
    if (link.phase == engine::LinkPhase::Finished)
        return link.url + ": played to its end";
    return {};
}

std::string sentence(const engine::Event &event, const std::map<channel::SessionId, std::string> &peers)
{
    const auto peer = [&peers](channel::SessionId session) {
        const auto found = peers.find(session);
        return found == peers.end() ? std::string("the peer") : found->second;
    };
    return std::visit(
        Overloaded{
            [](const engine::LinkChanged &e) { return linkText(e.link); },
            [](const engine::VehicleFound &e) {
                return format("vehicle %u found, %s", unsigned(e.systemId), e.sealed ? "sealed" : "NOT SEALED");
            },
            [](const engine::VehicleLost &e) { return format("vehicle %u lost", unsigned(e.systemId)); },
            [](const engine::VehicleBack &e) { return format("vehicle %u is back", unsigned(e.systemId)); },
            [](const vehicle::TextReceived &e) { return format("vehicle %u: %s", unsigned(e.systemId), e.text.text.c_str()); },
            [](const engine::PlaintextRefused &e) {
                return format("refused %llu clear frames of system %u from %s", static_cast<unsigned long long>(e.frames),
                              unsigned(e.systemId), e.remoteAddress.c_str());
            },
            [](const engine::SystemRefused &e) {
                const std::string what = format("refused %llu frames of %s: it speaks as system %u",
                                                static_cast<unsigned long long>(e.frames), e.peer.c_str(),
                                                unsigned(e.systemId));
                if (e.owner.empty())
                    return what + ", which it may not";
                return what + ", which is " + e.owner + "'s. Is it a new agent of the same vehicle? Then remove " + e.owner
                    + " from the list of peers, or bind the system to " + e.peer;
            },
            [](const engine::AgentUnanswering &e) {
                if (e.over)
                    return std::string(); // the session that is up, or the silence, says enough
                return "agent " + e.agent.peerName + " at " + e.agent.remoteAddress
                    + " is there but does not answer: does it know this station's key? " + e.agent.ownFingerprint;
            },
            [](const engine::RecordingProblem &e) { return "not recording: " + e.file + ": " + e.problem; },
            [](const vehicle::MissionResult &) { return std::string(); },
            [](const vehicle::ParameterResult &) { return std::string(); },
            [](const vehicle::CommandResult &) { return std::string(); },
            [](const channel::SessionUp &e) {
                return "sealed with " + e.peerName + " at " + link::toText(e.path.remote) + " by " + suiteText(e.suite);
            },
            [&](const channel::SessionDown &e) { return "session with " + peer(e.session) + " ended: " + whyDown(e.reason); },
            [&](const channel::PeerMoved &e) { return peer(e.session) + " is now at " + link::toText(e.to.remote); },
            [](const channel::SwitchPending &) { return std::string(); },
            [](const channel::SwitchDone &e) {
                if (e.failure != channel::SwitchFailure::None)
                    return "switch to " + suiteText(e.to) + " rolled back: " + whyRolledBack(e.failure);
                if (e.rekey)
                    return format("fresh keys, epoch %u", static_cast<unsigned>(e.epoch));
                const double ms = seconds(e.took) * 1000;
                return format("switched to %s, epoch %u, in %.*f ms", suiteText(e.to).c_str(), static_cast<unsigned>(e.epoch),
                              ms < 9.95 ? 1 : 0, ms);
            },
            [](const channel::HandshakeRefused &e) {
                if (e.reason == channel::RefusalReason::UnknownPeer && e.peer == channel::PublicKey{}) // heard by a station
                    return "an agent at " + link::toText(e.path.remote)
                        + " announces itself with a key that is not known here: pair the two (keys pair; beside it skyseal-air "
                          "--pair), or add its key (keys peers add)";
                std::string out = "refused a handshake from " + link::toText(e.path.remote) + ": " + whyRefused(e.reason);
                return e.peer == channel::PublicKey{} ? out : out + " (" + keys::fingerprint(e.peer) + ")";
            },
            [&](const channel::ForgeryAlarm &e) {
                return format("%llu forged and %llu replayed records claim to be %s's",
                              static_cast<unsigned long long>(e.forged), static_cast<unsigned long long>(e.replayed),
                              peer(e.session).c_str());
            },
        },
        event);
}

} // namespace skyseal::app
