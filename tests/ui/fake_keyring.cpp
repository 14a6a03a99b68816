#include "tests/ui/fake_keyring.h"

#include "core/crypto/passphrase.h"

namespace skyseal::ui {

void FakeKeyring::changePassphrase(std::optional<crypto::Passphrase> present, std::optional<crypto::Passphrase> next,
                                   bool remember)
{
    remembers = remember;
    const auto text = [](const auto &passphrase) {
        return passphrase ? std::string(asText(passphrase->view())) : std::string();
    };
    passphrases.emplace_back(text(present), text(next));
}

} // namespace skyseal::ui

#include "moc_fake_keyring.cpp"
