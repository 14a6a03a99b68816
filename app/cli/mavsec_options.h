// The options of --framing mavsec2019: how a stream of the paper's published code was encrypted.
#pragma once

#include "app/common/options.h"
#include "core/engine/station/mavsec_settings.h"

namespace skyseal::app {

/// --cipher, --key or --key-file, --nonce and --counter; what is not given is as in the published code.
class MavsecOptions
{
public:
    static void declare(Options &options);
    /// Problems with what was written; none when another framing was chosen and no such option given.
    static MavsecOptions read(Options &options);

    /// True for --framing mavsec2019.
    bool isChosen() const { return m_chosen; }
    /// Reads the key file. The error names it.
    Result<crypto::MavsecCipher, InputError> cipher() const;

private:
    bool m_chosen = false;
    engine::MavsecSettings m_settings;
    std::optional<Key32> m_key;
};

} // namespace skyseal::app
