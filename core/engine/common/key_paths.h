// The files with a program's private key and its known peers.
#pragma once

#include "core/keys/secret_file.h"

#include <memory>
#include <string>

namespace skyseal::engine {

/// With empty paths, the program can use plain links only.
struct KeyPaths
{
    std::string identity;                   ///< private key file
    std::string peers;                      ///< known peers
    keys::AskPassphrase askPassphrase = {}; ///< for an encrypted private key; empty: such a file is rejected
    /// The private key if it is open already; its file is not read then. Opening hashes a passphrase, which takes a second.
    std::shared_ptr<const crypto::X25519KeyPair> opened = {};
};

} // namespace skyseal::engine
