// What a sealed program reads before it can start: its private key, its known peers and its persisted counters.
#pragma once

#include "core/base/result.h"
#include "core/channel/counter_store.h"
#include "core/crypto/system_random.h"
#include "core/engine/common/key_paths.h"
#include "core/engine/common/sealed_systems.h"
#include "core/keys/peers_file.h"

#include <memory>
#include <vector>

namespace skyseal::engine {

struct SecretFiles
{
    KeyPaths paths;
    std::shared_ptr<const crypto::X25519KeyPair> identity;
    std::vector<channel::Peer> peers;
    SealedSystems sealedSystems; ///< that the peers were heard as, by earlier runs
    std::unique_ptr<channel::CounterStore> counters;
    crypto::SystemRandom random;
};

/// An error names the file and what is wrong with it: missing, readable by others, damaged. Here no peer is left out.
Result<std::unique_ptr<SecretFiles>, InputError> readSecretFiles(const KeyPaths &paths);
/// Where the systems of the peers are remembered.
inline std::string sealedSystemsFile(const KeyPaths &paths)
{
    return paths.peers + ".systems";
}

/// The peers of the file as it is now, but for those whose pre-shared key cannot be used: one bad file must not keep anybody
/// else who was removed in force.
struct PeerList
{
    std::vector<channel::Peer> peers;
    std::vector<InputError> unusable; ///< pre-shared keys; each message names its peer

    keys::PeersInForce inForce() const;
};
/// An error when the list itself cannot be read.
Result<PeerList, InputError> readPeers(const KeyPaths &paths);

} // namespace skyseal::engine
