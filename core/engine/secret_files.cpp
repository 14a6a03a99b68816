#include "core/engine/secret_files.h"

#include "core/keys/counter_file.h"
#include "core/keys/peers_file.h"
#include "core/keys/secret_file.h"

namespace skyseal::engine {

Result<std::unique_ptr<SecretFiles>, InputError> readSecretFiles(const KeyPaths &paths)
{
    auto identity = keys::loadIdentity(paths.identity, paths.askPassphrase);
    if (!identity)
        return tl::unexpected(identity.error());
    auto peers = readPeers(paths);
    if (!peers)
        return tl::unexpected(peers.error());
    // Beside the key that they belong to: a copied key without its counters would repeat numbers.
    auto counters = keys::FileCounterStore::open(paths.identity + ".counters");
    if (!counters)
        return tl::unexpected(counters.error());

    auto sealed = readSealedSystems(sealedSystemsFile(paths));
    if (!sealed)
        return tl::unexpected(sealed.error());

    auto out = std::make_unique<SecretFiles>();
    out->sealedSystems = std::move(*sealed);
    out->paths = paths;
    out->identity = std::make_shared<const crypto::X25519KeyPair>(std::move(*identity));
    out->peers = std::move(*peers);
    out->counters = std::move(*counters);
    return out;
}

Result<std::vector<channel::Peer>, InputError> readPeers(const KeyPaths &paths)
{
    if (paths.peers.empty())
        return std::vector<channel::Peer>{};
    const auto file = keys::PeersFile::load(paths.peers);
    if (!file)
        return tl::unexpected(file.error());
    std::vector<channel::Peer> out;
    for (const keys::PeerEntry &entry : file->entries()) {
        out.push_back(entry.peer);
        if (entry.presharedKeyFile.empty())
            continue;
        auto key = keys::loadPresharedKey(keys::presharedKeyPath(paths.peers, entry));
        if (!key)
            return tl::unexpected(key.error());
        out.back().presharedKey = std::make_shared<const Key32>(std::move(*key));
    }
    return out;
}

} // namespace skyseal::engine
