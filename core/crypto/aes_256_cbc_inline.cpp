// AES-256-CBC that keeps the length, for payloads that must fit where they were: ciphertext stealing (CBC-CS1 of the
// addendum to NIST SP 800-38A), and below one block residual block termination. See inline_cipher.h.
#include "core/crypto/cbc_chain.h"
#include "core/crypto/inline_then_mac.h"
#include "core/crypto/suite_factories.h"

#include <algorithm>

namespace skyseal::crypto {

namespace {

using Block = std::array<std::uint8_t, kCbcBlock>;

class Aes256CbcStealing
{
public:
    explicit Aes256CbcStealing(const RecordKeys &keys)
        : m_encrypt(keys.key, EvpDirection::Encrypt), m_decrypt(keys.key, EvpDirection::Decrypt), m_ivs(keys.iv)
    {}

    bool ready() const { return m_encrypt.ready() && m_decrypt.ready() && m_ivs.ready(); }

    /// In place: `plaintext` and `body` are the same bytes.
    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView body)
    {
        const std::uint8_t *iv = m_ivs.at(counter);
        if (!iv)
            return false;
        if (plaintext.size() < kCbcBlock)
            return cryptResidue(iv, body);
        const std::size_t rest = body.size() % kCbcBlock;
        const MutableByteView whole = body.first(body.size() - rest);
        if (!m_encrypt.encrypt(iv, whole))
            return false;
        if (rest == 0)
            return true;
        Block last{};
        std::copy(body.end() - static_cast<std::ptrdiff_t>(rest), body.end(), last.begin());
        if (!m_encrypt.encrypt(whole.data() + whole.size() - kCbcBlock, last))
            return false;
        std::copy(last.begin(), last.end(), body.end() - kCbcBlock);
        return true;
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        const std::uint8_t *iv = m_ivs.at(counter);
        if (!iv)
            return std::nullopt;
        if (body.size() < kCbcBlock)
            return cryptResidue(iv, body) ? std::optional(body.size()) : std::nullopt;
        const std::size_t rest = body.size() % kCbcBlock;
        const MutableByteView whole = body.first(body.size() - rest);
        // The last block, decrypted without chaining: the end of the plaintext xor the front of the block before, then the
        // rest of that block, which did not travel.
        Block last{};
        if (rest != 0) {
            static constexpr Block kZeros{};
            std::copy(body.end() - kCbcBlock, body.end(), last.begin());
            if (!m_decrypt.decrypt(kZeros.data(), last))
                return std::nullopt;
            std::uint8_t *const before = whole.data() + whole.size() - kCbcBlock;
            for (std::size_t i = 0; i < rest; ++i)
                last[i] ^= before[i];
            std::copy(last.begin() + static_cast<std::ptrdiff_t>(rest), last.end(), before + rest);
        }
        if (!m_decrypt.decrypt(iv, whole))
            return std::nullopt;
        std::copy_n(last.begin(), rest, body.end() - static_cast<std::ptrdiff_t>(rest));
        return body.size();
    }

private:
    bool cryptResidue(const std::uint8_t *iv, MutableByteView body)
    {
        static constexpr Block kZeros{};
        Block stream;
        std::memcpy(stream.data(), iv, stream.size());
        const bool made = m_encrypt.encrypt(kZeros.data(), stream);
        for (std::size_t i = 0; made && i < body.size(); ++i)
            body[i] ^= stream[i];
        sodium_memzero(stream.data(), stream.size());
        return made;
    }

    CbcChain m_encrypt;
    CbcChain m_decrypt;
    CbcIvs m_ivs;
};

} // namespace

std::unique_ptr<InlineCipher> makeInlineAes256Cbc(const RecordKeys &keys)
{
    return InlineThenMac<Aes256CbcStealing>::make(SuiteId::Aes256Cbc, keys);
}

} // namespace skyseal::crypto
