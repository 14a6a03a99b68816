// Reads the passphrase of a pairing.
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
    /// Null if no passphrase was requested; an error if it cannot be read or was not entered.
    Result<std::shared_ptr<const crypto::Passphrase>, InputError> passphrase() const;

private:
    PassphraseInput m_input;
    bool m_wanted = false;
};

} // namespace skyseal::app
