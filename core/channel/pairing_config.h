// The settings of one end of a pairing.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/role.h"

#include <memory>
#include <string>
#include <vector>

namespace skyseal::crypto {
class Passphrase;
struct X25519KeyPair;
} // namespace skyseal::crypto

namespace skyseal::channel {

inline constexpr Duration kPairingWindow = std::chrono::seconds(120);
inline constexpr std::size_t kMaxPairingName = 24; ///< bytes; longer names are cut between characters

struct PairingConfig
{
    Role role = Role::Station;
    std::shared_ptr<const crypto::X25519KeyPair> identity; ///< our static key
    std::string name;                                      ///< our name for the other end
    std::uint8_t systemId = 0;                             ///< our MAVLink system id, an agent's vehicle's; 0 = unknown
    /// A passphrase for this pairing, the same at both ends; null = none, and the users must compare the code.
    std::shared_ptr<const crypto::Passphrase> passphrase;
    /// Targets of an agent's calls, or of a station's requests for one; an all-zero address is the only peer of a link.
    std::vector<Path> callTo = {};
    std::vector<LinkId> listensOn = {}; ///< an agent's: where it calls those who request it
    Duration window = kPairingWindow;
};

} // namespace skyseal::channel
