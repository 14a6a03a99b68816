// Keeps a peer that was just paired: its line in the list of peers, and its pre-shared key in a file beside the list.
#pragma once

#include "core/base/result.h"
#include "core/channel/policy.h"

#include <string>
#include <string_view>

namespace skyseal::keys {

/// A name for the list made of what the other end calls itself, with "-" for what a name cannot hold; from its fingerprint
/// when nothing is left.
std::string fitPeerName(std::string_view claimed, const channel::PublicKey &key);

/// Whether a key that is known by that name already may be replaced: only when a person said so, with both fingerprints before
/// their eyes.
enum class KeyChange { Refused, Accepted };

/// Adds the peer. A key that is known already keeps its name here and its system ids; role and pre-shared key are the new ones.
/// The same holds for a name whose key is replaced.
Result<void, InputError> keepPairedPeer(const std::string &peersFile, const channel::Peer &peer, KeyChange change);

} // namespace skyseal::keys
