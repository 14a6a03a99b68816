// What a pairing tells the person at one end, as a value that travels: from the agent over its control socket to the terminal
// where somebody opened the window, and as a line of JSON to scripts.
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
        Seen,      ///< somebody is there, to be compared
        Confirmed, ///< the other end said yes
        Gone,      ///< the one that was there is not any more
        Other,     ///< somebody else tried
        Differs,   ///< a passphrase at one end alone
        Paired,    ///< kept, by the name `name`
        Over,      ///< the last word
        Refused,   ///< the window was not opened, or what was asked for cannot be done; also a last word
    };

    State state = State::Over;
    std::string name; ///< of the other end, made fit for the list
    channel::PeerRole role = channel::PeerRole::Pilot;
    channel::PublicKey key{};
    std::optional<channel::PublicKey> knownKey; ///< by that name another key is known
    std::optional<channel::PeerRole> knownRole; ///< of that key or name, when it is known
    std::string reason;                         ///< in words
    int seconds = 0;                            ///< that the window stays open

    /// One line, {"event":"pairing","state":…}, without its newline.
    std::string toJson() const;
    static std::optional<PairingStatus> fromJson(const QByteArray &line);
};

/// The status of an event; `known` is the list of this end, `callIt` the name that somebody chose here for the other one, if
/// any. Nothing for `Paired`: the owner keeps the peer first.
std::optional<PairingStatus> statusOf(const channel::PairingEvent &event, const keys::PeersFile &known,
                                      const std::string &callIt = {});

} // namespace skyseal::app
