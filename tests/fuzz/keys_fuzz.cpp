// The texts of key, peers and counter files: any bytes are safe, and what was read and written reads the same again.
#include "core/base/secret_bytes.h"
#include "core/crypto/x25519.h"
#include "core/crypto/init_crypto.h"
#include "core/keys/counter_file.h"
#include "core/keys/peers_file.h"
#include "core/keys/public_key_text.h"
#include "core/keys/sealed_key.h"
#include "core/keys/secret_file.h"

#include <cstdlib>

using namespace skyseal;
using namespace skyseal::keys;

static void must(bool holds)
{
    if (!holds)
        std::abort();
}

static void readPeers(std::string_view text)
{
    auto file = PeersFile::parse(text, "fuzz");
    if (!file) {
        must(file.error().line > 0 && !file.error().message.empty());
        return;
    }
    const auto again = PeersFile::parse(file->text(), "fuzz");
    must(again && again->text() == file->text() && again->entries().size() == file->entries().size());
    for (const PeerEntry &entry : file->entries()) {
        must(file->find(entry.peer.name) != nullptr);
        must(file->remove(entry.peer.name) && file->add(entry)); // written by us it reads back, too
    }
    must(PeersFile::parse(file->text(), "fuzz")->entries().size() == again->entries().size());
}

static void readSealed(std::string_view text)
{
    const auto key = SealedKey::parse(text, "fuzz");
    if (!key) {
        must(!key.error().message.empty());
        return;
    }
    must(isAcceptable(key->cost)); // whatever the file says, opening it is affordable
    const auto again = SealedKey::parse(key->text(), "fuzz");
    must(again && again->text() == key->text() && again->sealed == key->sealed && again->salt == key->salt);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const bool ready = crypto::initCrypto();
    must(ready);
    const std::string_view text = asText({data, size});
    readPeers(text);
    if (const auto key = publicKeyFromText(text))
        must(publicKeyFromText(publicKeyText(*key)).value() == *key);
    static_cast<void>(parseSecretFile(SecretKind::PrivateKey, text, "fuzz"));
    static_cast<void>(parseSecretFile(SecretKind::PresharedKey, text, "fuzz"));
    static_cast<void>(parseIdentity(text, "fuzz", {}));
    readSealed(text);
    if (const auto counters = StoredCounters::parse(text, "fuzz"))
        must(StoredCounters::parse(counters->text(), "fuzz")->text() == counters->text());
    return 0;
}
