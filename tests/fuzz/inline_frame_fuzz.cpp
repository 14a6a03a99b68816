// The reader of frames sealed in place, and the sealer, over any bytes: as they came, with the checksum made good as anyone
// can do, and as plain frames. Nothing opens that was not sealed, and whatever can be sealed opens as the very same bytes.
#include "core/base/secret_bytes.h"
#include "core/channel/inline_frame.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/suite.h"
#include "core/engine/common/dialect_traits.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

using namespace skyseal;
using namespace skyseal::channel;

namespace {

std::vector<std::unique_ptr<crypto::InlineCipher>> allCiphers()
{
    std::vector<std::unique_ptr<crypto::InlineCipher>> out;
    for (const crypto::SuiteId suite : crypto::sealedSuites()) {
        if (auto cipher = crypto::makeInlineCipher(suite, Key32()))
            out.push_back(std::move(cipher));
    }
    return out;
}

void refuse(Bytes frame, const MessageTraits &facts, crypto::InlineCipher &cipher)
{
    const auto read = InlineFrame::read(frame, facts);
    if (read && read->open(Direction::FromResponder, Carrier::Datagram, cipher))
        std::abort();
}

void makeChecksumGood(Bytes &frame, std::uint8_t flags, std::size_t trailer, const MessageTraits &facts)
{
    if (frame.size() < 12 + trailer || frame.size() > 267 + trailer)
        return;
    frame[0] = 0xfd;
    frame[1] = static_cast<std::uint8_t>(frame.size() - 12 - trailer);
    frame[2] = flags;
    const auto message = facts.message(frame[7] | frame[8] << 8 | frame[9] << 16);
    if (!message) {
        frame[7] = frame[8] = frame[9] = 0;
        return makeChecksumGood(frame, flags, trailer, facts);
    }
    const std::size_t end = 10 + frame[1];
    const std::uint16_t crc = facts.checksum(ByteView(frame).subspan(1, end - 1), message->crcExtra);
    frame[end] = static_cast<std::uint8_t>(crc);
    frame[end + 1] = static_cast<std::uint8_t>(crc >> 8);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const bool ready = crypto::initCrypto();
    static const engine::DialectTraits facts(mavlink::Dialect::builtin());
    if (!ready || size < 2)
        return 0;
    static const auto ciphers = allCiphers();
    crypto::InlineCipher &cipher = *ciphers[data[0] % ciphers.size()];
    Bytes bytes(data + 1, data + size);
    refuse(bytes, facts, cipher);
    Bytes repaired = bytes;
    makeChecksumGood(repaired, kInlineFlags, kInlineTrailer, facts);
    refuse(std::move(repaired), facts, cipher);

    makeChecksumGood(bytes, 0, 0, facts);
    const auto sealable = SealableFrame::read(bytes, facts);
    if (!sealable)
        return 0;
    Bytes sealed(sealable->sealedSize());
    if (!sealable->seal({data[0], 77, Direction::FromResponder, Carrier::Datagram}, cipher, sealed))
        std::abort();
    const auto read = InlineFrame::read(sealed, facts);
    const auto opened = read ? read->open(Direction::FromResponder, Carrier::Datagram, cipher) : std::nullopt;
    if (!opened || !std::equal(opened->begin(), opened->end(), bytes.begin(), bytes.end()))
        std::abort();
    return 0;
}
