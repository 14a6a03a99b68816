// Rare events of the gateway, as values.
#pragma once

#include "core/engine/common/link_snapshot.h"

#include <string>
#include <variant>

namespace skyseal::engine {

/// The state of a link on which clients are served.
struct ServedLinkChanged
{
    LinkSnapshot link;
};
struct ClientConnected
{
    std::string name, address;
    std::string write; ///< what it may write: "none", "all" or classes of messages
};
struct ClientGone
{
    std::string name, address;
};
/// Frames of a client were not forwarded; at most once a minute for each client.
struct ClientDenied
{
    std::string name, address;
    std::string message; ///< the newest one's name; its number if no definition is known
    std::uint64_t frames = 0;
};
/// Clients connected, left and were denied frames more often than single events are published.
struct ClientsUnreported
{
    std::uint64_t clients = 0; ///< that connected and disconnected
    std::uint64_t frames = 0;  ///< frames that were not forwarded
};

using GatewayEvent = std::variant<ServedLinkChanged, ClientConnected, ClientGone, ClientDenied, ClientsUnreported>;

} // namespace skyseal::engine
