// The key that both ends make of the passphrase of a pairing: section 13 of PROTOCOL.md. It knows no file and no screen.
#pragma once

#include "core/crypto/passphrase_box.h"

#include <memory>

namespace skyseal::channel {

/// Less than for a key file: a passphrase for one pairing is worth nothing afterwards, and the machine beside an autopilot
/// is small. Both ends must use the same.
inline constexpr crypto::PassphraseCost kPairingPassphraseCost{3, 64 * 1024};

/// Takes a tenth of a second of one core and 64 MiB for that time: not on a thread that flies. Null when the machine has not
/// as much memory.
std::shared_ptr<const Key32> pairingPassphraseKey(const crypto::Passphrase &passphrase);

} // namespace skyseal::channel
