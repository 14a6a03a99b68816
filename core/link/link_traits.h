// The properties of a link that decide how its users treat it. They follow from the URL alone and never change, so a user
// reads them once, when the link opens, instead of comparing schemes for each packet.
#pragma once

namespace skyseal::link {

struct LinkTraits
{
    /// Blocks are pieces of a byte stream; otherwise each block is one datagram or one recorded frame.
    bool isStream = false;
    /// There is exactly one remote end, so that blocks need no destination address.
    bool hasOneRemote = false;
    /// Binds a local port and waits for peers.
    bool isListening = false;
    /// Replays a file: sent blocks are dropped, and received frames were recorded in the past.
    bool isRecording = false;
    /// A serial line at the speed of a telemetry radio: frames should be coalesced before they are sealed.
    bool isSlow = false;

    /// Sends datagrams to one address. The remote end learns the local address from the first of them.
    constexpr bool isDatagramClient() const { return hasOneRemote && !isStream; }
    /// Receives datagrams on a bound port; the remote addresses are those of the senders.
    constexpr bool isDatagramServer() const { return isListening && !isStream; }

    bool operator==(const LinkTraits &) const = default;
};

} // namespace skyseal::link
