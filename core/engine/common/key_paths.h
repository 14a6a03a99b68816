// Where a sealed program finds its private key and its known peers.
#pragma once

#include "core/keys/secret_file.h"

#include <string>

namespace skyseal::engine {

/// Where the secrets and the known peers are; empty paths mean a program that can only do plain links.
struct KeyPaths
{
    std::string identity;                   ///< private key file
    std::string peers;                      ///< known peers
    keys::AskPassphrase askPassphrase = {}; ///< when the private key is sealed; empty = such a file is refused
};

} // namespace skyseal::engine
