#include "core/engine/headless/event_names.h"

namespace skyseal::engine {

std::string_view keyword(LinkPhase phase)
{
    switch (phase) {
    case LinkPhase::Closed: return "closed";
    case LinkPhase::Opening: return "opening";
    case LinkPhase::Listening: return "listening";
    case LinkPhase::Connected: return "connected";
    case LinkPhase::Waiting: return "waiting";
    case LinkPhase::Finished: return "finished";
    case LinkPhase::Failed: return "failed";
    }
    return "unknown";
}

std::string_view keyword(Carrier carrier)
{
    switch (carrier) {
    case Carrier::Datagram: return "datagram";
    case Carrier::Tunnel: return "tunnel";
    case Carrier::Serial: return "serial";
    }
    return "unknown";
}

std::string_view keyword(channel::Framing framing)
{
    return framing == channel::Framing::Inline ? "inline" : "sealed";
}

std::string_view keyword(channel::DownReason reason)
{
    switch (reason) {
    case channel::DownReason::PeerRestarted: return "peer-restarted";
    case channel::DownReason::PeerClosed: return "peer-closed";
    case channel::DownReason::TimedOut: return "timed-out";
    case channel::DownReason::Exhausted: return "exhausted";
    case channel::DownReason::Revoked: return "revoked";
    case channel::DownReason::Closed: return "closed";
    case channel::DownReason::Cloned: return "cloned";
    }
    return "unknown";
}

std::string_view keyword(channel::SwitchFailure failure)
{
    switch (failure) {
    case channel::SwitchFailure::None: return "";
    case channel::SwitchFailure::NotAllowedHere: return "not-allowed-here";
    case channel::SwitchFailure::NotAllowedByPeer: return "not-allowed-by-peer";
    case channel::SwitchFailure::NotConfirmed: return "not-confirmed";
    case channel::SwitchFailure::Superseded: return "superseded";
    case channel::SwitchFailure::SessionEnded: return "session-ended";
    }
    return "unknown";
}

std::string_view keyword(channel::RefusalReason reason)
{
    switch (reason) {
    case channel::RefusalReason::UnknownPeer: return "unknown-peer";
    case channel::RefusalReason::WrongKey: return "wrong-key";
    case channel::RefusalReason::ReplayedHandshake: return "replayed-handshake";
    case channel::RefusalReason::NoCommonSuite: return "no-common-suite";
    case channel::RefusalReason::OfferTampered: return "offer-tampered";
    case channel::RefusalReason::Version: return "version";
    case channel::RefusalReason::CounterBehind: return "counter-behind";
    case channel::RefusalReason::CountersUsedUp: return "counters-used-up";
    case channel::RefusalReason::Flood: return "flood";
    }
    return "unknown";
}

} // namespace skyseal::engine
