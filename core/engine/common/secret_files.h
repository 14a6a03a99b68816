// The files that a program with sealed links reads before it starts: private key, known peers and persisted counters.
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
    const channel::PublicKey &publicKey() const;

    KeyPaths paths;
    std::shared_ptr<const crypto::X25519KeyPair> identity;
    std::vector<channel::Peer> peers;
    SealedSystems sealedSystems; ///< used by the peers in earlier runs
    std::unique_ptr<channel::CounterStore> counters;
    crypto::SystemRandom random;
};

/// An error names the file and the reason: missing, readable by others, damaged. An unusable pre-shared key is an error.
Result<std::unique_ptr<SecretFiles>, InputError> readSecretFiles(const KeyPaths &paths);
/// The file for writeSealedSystems().
inline std::string sealedSystemsFile(const KeyPaths &paths)
{
    return paths.peers + ".systems";
}

} // namespace skyseal::engine
