#include "app/common/pairing_passphrase_input.h"

#include "core/crypto/passphrase.h"

namespace skyseal::app {

void PairingPassphraseInput::declare(Options &options)
{
    options.addFlag("pair-passphrase",
                    "Use a passphrase for this pairing instead of a code, the same at both ends; prompts for it.");
    PassphraseInput::declare(options, "pair-", "the passphrase of this pairing");
}

PairingPassphraseInput PairingPassphraseInput::read(Options &options)
{
    PairingPassphraseInput out;
    out.m_input = PassphraseInput::read(options, "pair-");
    out.m_wanted = options.has("pair-passphrase") || out.m_input.isGiven();
    return out;
}

Result<std::shared_ptr<const crypto::Passphrase>, InputError> PairingPassphraseInput::passphrase() const
{
    if (!m_wanted)
        return nullptr;
    auto passphrase = m_input.once("Passphrase of this pairing, the same at both ends: ");
    if (!passphrase)
        return tl::unexpected(passphrase.error());
    return std::make_shared<const crypto::Passphrase>(std::move(*passphrase));
}

} // namespace skyseal::app
