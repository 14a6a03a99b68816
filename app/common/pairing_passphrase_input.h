// How the passphrase of a pairing comes into a program, and what the pairing gets of it.
#pragma once

#include "app/common/passphrase_input.h"

#include <memory>

namespace skyseal::app {

class PairingPassphraseInput
{
public:
    /// Declares --pair-passphrase, --pair-passphrase-file and --pair-passphrase-fd.
    static void declare(Options &options);
    static PairingPassphraseInput read(Options &options);

    bool isWanted() const { return m_wanted; }
    /// Null when none is wanted. An error in words when it cannot be read or was not typed. Call crypto::initCrypto() first.
    Result<std::shared_ptr<const Key32>, InputError> key() const;

private:
    PassphraseInput m_input;
    bool m_wanted = false;
};

} // namespace skyseal::app
