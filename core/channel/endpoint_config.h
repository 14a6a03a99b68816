// Configuration of an endpoint: plain values that its owner fills in before it makes one.
#pragma once

#include "core/base/path.h"
#include "core/channel/freshness.h"
#include "core/channel/policy.h"
#include "core/channel/role.h"
#include "core/channel/timing.h"

#include <memory>
#include <vector>

namespace skyseal::crypto {
struct X25519KeyPair;
}

namespace skyseal::channel {

class MessageTraits;

struct Config
{
    Role role = Role::Station;
    std::shared_ptr<const crypto::X25519KeyPair> identity; ///< our static key
    std::vector<Peer> peers;
    Policy policy;
    Timing timing;
    FreshnessLimits freshness; ///< of the records that an agent receives
    /// An agent's announcement targets; it adds the addresses of authenticated sessions. An all-zero address stands for the
    /// single peer of a link that has only one.
    std::vector<Path> announceTo;
    /// A station's: addresses at which agents listen that do not announce themselves. The station sends first messages there to
    /// its agents without a session.
    std::vector<Path> callAt = {};
    /// Layout of MAVLink messages. Null disables inline framing regardless of the policy.
    std::shared_ptr<const MessageTraits> messageTraits = nullptr;
};

} // namespace skyseal::channel
