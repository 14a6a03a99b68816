#include "core/engine/common/secret_files.h"

#include "core/base/locked_memory.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/x25519.h"
#include "core/keys/counter_file.h"
#include "core/keys/secret_file.h"
#include "core/keys/usable_peers.h"

namespace skyseal::engine {

const channel::PublicKey &SecretFiles::publicKey() const
{
    return identity->publicKey;
}

static Result<std::shared_ptr<const crypto::X25519KeyPair>, InputError> identityOf(const KeyPaths &paths)
{
    if (paths.opened)
        return paths.opened;
    return keys::loadIdentity(paths.identity, paths.askPassphrase).map([](crypto::X25519KeyPair &&pair) {
        return shareInLockedMemory(std::move(pair));
    });
}

Result<std::unique_ptr<SecretFiles>, InputError> readSecretFiles(const KeyPaths &paths)
{
    auto identity = identityOf(paths);
    if (!identity)
        return tl::unexpected(identity.error());
    auto peers = keys::readPeers(paths.peers);
    if (!peers)
        return tl::unexpected(peers.error());
    if (!peers->unusable.empty())
        return tl::unexpected(peers->unusable.front());
    // Next to the key of the counters: a key that is copied without its counters would repeat them.
    auto counters = keys::FileCounterStore::open(paths.identity + ".counters");
    if (!counters)
        return tl::unexpected(counters.error());

    auto sealed = readSealedSystems(sealedSystemsFile(paths));
    if (!sealed)
        return tl::unexpected(sealed.error());

    auto out = std::make_unique<SecretFiles>();
    out->sealedSystems = std::move(*sealed);
    out->paths = paths;
    out->identity = std::move(*identity);
    out->peers = std::move(peers->peers);
    out->counters = std::move(*counters);
    return out;
}

} // namespace skyseal::engine
