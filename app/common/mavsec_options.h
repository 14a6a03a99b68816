// The options of --framing mavsec2019: the encryption of a stream of the paper's published code.
#pragma once

#include "app/common/options.h"
#include "core/base/secret_bytes_fwd.h"
#include "core/engine/common/mavsec_settings.h"

#include <memory>

namespace skyseal::app {

/// --cipher, --key or --key-file, --nonce and --counter; defaults are the values of the published code.
class MavsecOptions
{
public:
    static void declare(Options &options);
    /// Checks the options. They are rejected with another framing.
    static MavsecOptions read(Options &options);

    /// True for --framing mavsec2019.
    bool isChosen() const { return m_chosen; }
    crypto::MavsecKind kind() const { return m_settings.kind; }
    /// Reads the key file. The error names it.
    Result<crypto::MavsecCipher, InputError> cipher() const;
    /// Of another kind than --cipher, under the same key.
    Result<crypto::MavsecCipher, InputError> cipher(crypto::MavsecKind kind) const;

private:
    bool m_chosen = false;
    engine::MavsecSettings m_settings;
    std::shared_ptr<const Key32> m_key; ///< null: that of the published code
};

} // namespace skyseal::app
