#include "app/sim/sent_framing.h"

#include "core/crypto/mavsec_cipher.h"

#include <utility>
#include <vector>

namespace skyseal::app {

using crypto::MavsecKind;

Result<SentFraming, InputError> SentFraming::make(const MavsecOptions &options, bool isSwitched)
{
    SentFraming out;
    if (!options.isChosen())
        return out;
    std::vector<MavsecKind> kinds{options.kind()};
    if (isSwitched)
        kinds = {MavsecKind::ChaCha20, MavsecKind::Aes256Ctr};
    for (const MavsecKind kind : kinds) {
        auto cipher = options.cipher(kind);
        if (!cipher)
            return tl::unexpected(cipher.error());
        out.m_streams.try_emplace(kind, std::move(*cipher), mavlink::Dialect::builtin());
    }
    if (!isSwitched)
        out.m_kind = options.kind();
    return out;
}

bool SentFraming::use(std::optional<MavsecKind> kind)
{
    if (kind && !m_streams.contains(*kind))
        return false;
    m_kind = kind;
    return true;
}

ByteView SentFraming::framed(ByteView clear)
{
    if (!m_kind)
        return clear;
    const auto frame = mavlink::readFrame(clear, mavlink::Dialect::builtin());
    return frame ? m_streams.at(*m_kind).seal(*frame).bytes() : clear;
}

} // namespace skyseal::app
