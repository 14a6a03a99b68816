// The list of known peers as a program uses it: with the pre-shared keys that the list refers to.
#pragma once

#include "core/base/reason.h"
#include "core/base/result.h"
#include "core/channel/policy.h"

#include <vector>

namespace skyseal::keys {

/// The result of reloading a list that changed while the program runs.
struct PeersInForce
{
    std::size_t count = 0;
    Reason leftOut; ///< peers whose pre-shared key cannot be used, and why; empty if there are none
};

/// The peers of the current file, except those whose pre-shared key cannot be used: one bad key file must not keep peers in
/// force that were removed from the list.
struct UsablePeers
{
    std::vector<channel::Peer> peers;
    std::vector<InputError> unusable; ///< pre-shared keys; each message names its peer

    PeersInForce inForce() const;
};

/// No peers if `peersFile` is empty. An error if the list itself cannot be read.
Result<UsablePeers, InputError> readPeers(const std::string &peersFile);

} // namespace skyseal::keys
