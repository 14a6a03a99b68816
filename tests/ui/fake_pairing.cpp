#include "tests/ui/fake_pairing.h"

#include "core/crypto/passphrase.h"

namespace skyseal::ui {

void FakePairing::open(const std::optional<crypto::Passphrase> &passphrase)
{
    passphrases.push_back(passphrase ? std::string(asText(passphrase->view())) : std::string());
}

} // namespace skyseal::ui

#include "moc_fake_pairing.cpp"
