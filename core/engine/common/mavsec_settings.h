// The operator's settings of the encryption of a stream of MAVSec's published code (mavsec_stream.h), and the cipher for it.
// The defaults are the values in the published code.
#pragma once

#include "core/base/result.h"
#include "core/base/secret_bytes_fwd.h"
#include "core/crypto/mavsec_kind.h"

#include <optional>
#include <string>
#include <string_view>

namespace skyseal::crypto {
class MavsecCipher;
}

namespace skyseal::engine {

struct MavsecSettings
{
    crypto::MavsecKind kind = crypto::MavsecKind::ChaCha20;
    std::string keyFile;  ///< 32 bytes or 64 hex digits, readable by its owner only; empty: the published key
    std::string nonceHex; ///< empty: the published one
    std::uint32_t counter = crypto::kPublishedMavsecCounter; ///< ChaCha20 only
    crypto::MavsecWork work = crypto::MavsecWork::Once;
};

/// 64 hex digits; nullopt for anything else.
std::optional<Key32> mavsecKeyFromHex(std::string_view text);

/// Reads the key file, if one is named. The error names the file, or the expected form of the nonce.
Result<crypto::MavsecCipher, InputError> makeMavsecCipher(const MavsecSettings &settings);
/// The same with a given key.
Result<crypto::MavsecCipher, InputError> makeMavsecCipher(const MavsecSettings &settings, const Key32 &key);

} // namespace skyseal::engine
