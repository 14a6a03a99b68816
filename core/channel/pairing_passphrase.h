// Derives the key of a pairing passphrase (PROTOCOL.md, section 13).
#pragma once

#include "core/crypto/passphrase_box.h"

#include <memory>

namespace skyseal::channel {

/// Less than for a key file: the passphrase of one pairing is worthless afterwards, and a companion computer is small. Both
/// ends must use the same value.
inline constexpr crypto::PassphraseCost kPairingPassphraseCost{3, 64 * 1024};

/// Takes a tenth of a second of one core and 64 MiB: do not call it on the I/O thread in flight. Returns null if there is not
/// enough memory.
std::shared_ptr<const Key32> pairingPassphraseKey(const crypto::Passphrase &passphrase);

} // namespace skyseal::channel
