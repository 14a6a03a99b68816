// How the simulator frames what it sends: in clear, or with payloads encrypted as by the autopilot that was published with the
// paper MAVSec (2019). INSECURE (core/crypto/mavsec_cipher.h): for comparison. Received frames are always in clear.
#pragma once

#include "app/common/mavsec_options.h"
#include "core/engine/common/mavsec_stream.h"

#include <map>
#include <optional>

namespace skyseal::app {

class SentFraming
{
public:
    /// In clear, unless the options name --framing mavsec2019. `isSwitched`: both ciphers are ready for use(), under one key,
    /// and frames are in clear until then. The error names the key file.
    static Result<SentFraming, InputError> make(const MavsecOptions &options, bool isSwitched);

    /// nullopt: in clear. False for a cipher that make() did not prepare.
    bool use(std::optional<crypto::MavsecKind> kind);
    std::optional<crypto::MavsecKind> kind() const { return m_kind; }
    /// The frame as it is sent; valid until the next call.
    ByteView framed(ByteView clear);

private:
    std::map<crypto::MavsecKind, engine::MavsecStream> m_streams;
    std::optional<crypto::MavsecKind> m_kind;
};

} // namespace skyseal::app
