#include "app/common/pairing_passphrase_input.h"

#include "core/channel/pairing_passphrase.h"

namespace skyseal::app {

void PairingPassphraseInput::declare(Options &options)
{
    options.addFlag("pair-passphrase", "Use a passphrase for this pairing, the same at both ends; prompts for it.");
    PassphraseInput::declare(options, "pair-", "the passphrase of this pairing");
}

PairingPassphraseInput PairingPassphraseInput::read(Options &options)
{
    PairingPassphraseInput out;
    out.m_input = PassphraseInput::read(options, "pair-");
    out.m_wanted = options.has("pair-passphrase") || out.m_input.isGiven();
    return out;
}

Result<std::shared_ptr<const Key32>, InputError> PairingPassphraseInput::key() const
{
    if (!m_wanted)
        return nullptr;
    const auto passphrase = m_input.once("Passphrase of this pairing, the same at both ends: ");
    if (!passphrase)
        return tl::unexpected(passphrase.error());
    auto key = channel::pairingPassphraseKey(*passphrase);
    if (!key)
        return tl::unexpected(InputError{"not enough memory to derive a key from the passphrase", {}});
    return key;
}

} // namespace skyseal::app
