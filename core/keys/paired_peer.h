// Stores a peer after pairing: its line in the list of peers, and its pre-shared key in a file next to the list.
#pragma once

#include "core/base/result.h"
#include "core/channel/policy.h"

#include <string>
#include <string_view>

namespace skyseal::keys {

/// A valid name for the list from the name that the other end claims, with invalid characters replaced by "-"; from its
/// fingerprint if nothing remains.
std::string fitPeerName(std::string_view claimed, const channel::PublicKey &key);

/// Whether the key of a known name may be replaced. Accepted only if the user confirmed it after seeing both fingerprints.
enum class KeyChange { Refused, Accepted };

/// Whether several peers may be bound to one system id. Stations may share one; two agents with one id lock each other out.
enum class SharedIds { Refused, Allowed };

/// Adds the peer. A known key keeps its name and system ids here, with the new role and pre-shared key. The same applies to
/// a name whose key is replaced. With SharedIds::Refused it fails if a new peer has the system id of another one.
Result<void, InputError> keepPairedPeer(const std::string &peersFile, const channel::Peer &peer, KeyChange change,
                                        SharedIds ids);

} // namespace skyseal::keys
