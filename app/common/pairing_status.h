// The status of a pairing for the user at one end. Sent by the agent through its control socket to the terminal that opened the
// window, and printed as a line of JSON for scripts.
#pragma once

#include "core/channel/pairing.h"
#include "core/keys/peers_file.h"

#include <QtCore/QByteArray>

#include <optional>
#include <string>

namespace skyseal::app {

struct PairingStatus
{
    enum class State {
        Open,      ///< the window is open; `key` is our own
        Seen,      ///< a peer is present; the code is to be compared
        Confirmed, ///< the other end has confirmed
        Other,     ///< another device tried
        Differs,   ///< the passphrases differ, or only one end has one
        Paired,    ///< stored under `name`
        Over,      ///< ended; the last status
        Refused,   ///< the window was not opened or the request failed; also a last status
    };

    State state = State::Over;
    std::string name;                      ///< of the peer, made valid for the list
    std::string code;                      ///< "123 456", to be compared
    std::uint8_t systemId = 0;             ///< MAVLink system id of the peer; 0 = unknown
    std::optional<channel::PeerRole> role; ///< as it was stored
    channel::PublicKey key{};
    std::optional<channel::PublicKey> knownKey; ///< the other key that is known by this name
    std::optional<channel::PeerRole> knownRole; ///< of that key or name, if known
    std::string reason;                         ///< text; with Paired, a part of the request that was refused
    int seconds = 0;                            ///< for which the window stays open

    /// One line, {"event":"pairing","state":…}, without its newline.
    std::string toJson() const;
    static std::optional<PairingStatus> fromJson(const QByteArray &line);
};

/// The status of an event. `known`: the list of this end; `callIt`: the name chosen here for the peer, if any. Nothing for
/// `Paired`: the owner stores the peer first.
std::optional<PairingStatus> statusOf(const channel::PairingEvent &event, const keys::PeersFile &known,
                                      const std::string &callIt = {});

} // namespace skyseal::app
