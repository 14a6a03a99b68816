#include "core/crypto/mavsec_cipher.h"

#include "core/base/secret_bytes.h"
#include "core/crypto/evp.h"

#include <sodium.h>

#include <algorithm>
#include <array>

namespace skyseal::crypto {

/// The same libraries and, for AES, the same way to the key stream as in the suites of these ciphers (suites/), so that the two
/// differ by the authentication alone.
class MavsecCipher::EachFrame
{
public:
    EachFrame(Kind kind, const Key32 &key, ByteView nonce, std::uint32_t counter)
        : m_kind(kind), m_key(key.clone()), m_nonce(nonce.begin(), nonce.end()), m_counter(counter)
    {
        if (kind != Kind::Aes256Ctr)
            return;
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-ECB", nullptr));
        m_context = makeEvpContext(cipher.get(), key.view().data(), EvpDirection::Encrypt);
    }

    bool ready() const { return m_kind != Kind::Aes256Ctr || m_context; }

    /// At most 255 bytes.
    bool apply(MutableByteView payload)
    {
        if (payload.empty()) // libsodium declares its pointers nonnull
            return true;
        if (m_kind == Kind::ChaCha20)
            return crypto_stream_chacha20_ietf_xor_ic(payload.data(), payload.data(), payload.size(), m_nonce.data(), m_counter,
                                                      m_key.view().data())
                == 0;
        const MutableByteView stream = m_stream.mutableView();
        const std::size_t size = (payload.size() + kBlock - 1) / kBlock * kBlock;
        std::array<std::uint8_t, kBlock> block{};
        std::copy(m_nonce.begin(), m_nonce.end(), block.begin());
        for (std::size_t at = 0; at < size; at += kBlock) {
            std::copy(block.begin(), block.end(), stream.begin() + static_cast<std::ptrdiff_t>(at));
            countUp(block);
        }
        int written = 0;
        if (EVP_EncryptUpdate(m_context.get(), stream.data(), &written, stream.data(), static_cast<int>(size)) != 1)
            return false;
        for (std::size_t i = 0; i < payload.size(); ++i)
            payload[i] ^= stream[i];
        return true;
    }

private:
    static constexpr std::size_t kBlock = 16;

    /// The counter of NIST SP 800-38A B.1: the whole block, big-endian.
    static void countUp(std::array<std::uint8_t, kBlock> &block)
    {
        for (std::size_t i = kBlock; i > 0 && ++block[i - 1] == 0; --i) {}
    }

    Kind m_kind;
    Key32 m_key;
    Bytes m_nonce;
    std::uint32_t m_counter;
    EvpContext m_context; ///< AES only
    SecretBytes<256> m_stream;
};

struct MavsecCipher::State
{
    SecretBytes<256> stream; ///< the same for every frame
    std::unique_ptr<EachFrame> eachFrame;
};

MavsecCipher::MavsecCipher() : m_state(std::make_unique<State>()) {}
MavsecCipher::MavsecCipher(MavsecCipher &&) noexcept = default;
MavsecCipher &MavsecCipher::operator=(MavsecCipher &&) noexcept = default;
MavsecCipher::~MavsecCipher() = default;

std::optional<MavsecCipher> MavsecCipher::make(Kind kind, const Key32 &key, ByteView nonce, std::uint32_t counter,
                                               MavsecWork work)
{
    if (nonce.size() != nonceLength(kind))
        return std::nullopt;
    MavsecCipher cipher;
    if (work == MavsecWork::EachFrame) {
        cipher.m_state->eachFrame = std::make_unique<EachFrame>(kind, key, nonce, counter);
        if (!cipher.m_state->eachFrame->ready())
            return std::nullopt;
    }
    const MutableByteView stream = cipher.m_state->stream.mutableView();
    if (kind == Kind::ChaCha20) {
        crypto_stream_chacha20_ietf_xor_ic(stream.data(), stream.data(), stream.size(), nonce.data(), counter,
                                           key.view().data());
        return cipher;
    }
    const EvpCipher aes(EVP_CIPHER_fetch(nullptr, "AES-256-CTR", nullptr));
    const EvpContext context = makeEvpContext(aes.get(), key.view().data(), EvpDirection::Encrypt);
    int written = 0;
    const bool done = context && EVP_EncryptInit_ex2(context.get(), nullptr, nullptr, nonce.data(), nullptr) == 1
        && EVP_EncryptUpdate(context.get(), stream.data(), &written, stream.data(), static_cast<int>(stream.size())) == 1;
    return done ? std::optional(std::move(cipher)) : std::nullopt;
}

Key32 MavsecCipher::publishedKey(Kind kind)
{
    Key32 key;
    if (kind == Kind::ChaCha20) {
        for (std::size_t i = 0; i < key.size(); ++i)
            key.mutableView()[i] = static_cast<std::uint8_t>(i);
        return key;
    }
    // The AES-256 key of the examples in NIST SP 800-38A, appendix F.
    static constexpr std::array<std::uint8_t, 32> kExample{0x60, 0x3d, 0xeb, 0x10, 0x15, 0xca, 0x71, 0xbe, 0x2b, 0x73, 0xae,
                                                           0xf0, 0x85, 0x7d, 0x77, 0x81, 0x1f, 0x35, 0x2c, 0x07, 0x3b, 0x61,
                                                           0x08, 0xd7, 0x2d, 0x98, 0x10, 0xa3, 0x09, 0x14, 0xdf, 0xf4};
    std::copy(kExample.begin(), kExample.end(), key.mutableView().begin());
    return key;
}

Bytes MavsecCipher::publishedNonce(Kind kind)
{
    if (kind == Kind::ChaCha20)
        return {0, 0, 0, 0, 0, 0, 0, 0x4a, 0, 0, 0, 0};
    Bytes counter(16);
    for (std::size_t i = 0; i < counter.size(); ++i)
        counter[i] = static_cast<std::uint8_t>(0xf0 + i);
    return counter;
}

MavsecCipher MavsecCipher::clone() const
{
    MavsecCipher copy;
    copy.m_state->stream = m_state->stream.clone();
    return copy;
}

void MavsecCipher::apply(MutableByteView payload) const
{
    const auto stream = m_state->stream.view();
    const std::size_t size = std::min(payload.size(), stream.size());
    if (m_state->eachFrame && m_state->eachFrame->apply(payload.first(size)))
        return;
    for (std::size_t i = 0; i < size; ++i)
        payload[i] ^= stream[i];
}

} // namespace skyseal::crypto
