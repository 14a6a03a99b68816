// AES-256 in cipher block chaining (NIST SP 800-38A 6.2), then HMAC. Records are padded by PKCS#7. Frames that are sealed in
// place keep their length by ciphertext stealing (CBC-CS1 of the addendum to SP 800-38A) and, below one block, by residual
// block termination; see inline_cipher.h.
#include "core/crypto/cbc_chain.h"
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/inline_then_mac.h"

#include <sodium.h>

namespace skyseal::crypto {

namespace {

class Aes256CbcBody
{
public:
    explicit Aes256CbcBody(const RecordKeys &keys)
        : m_encrypt(keys.key, EvpDirection::Encrypt), m_decrypt(keys.key, EvpDirection::Decrypt), m_ivs(keys.iv)
    {}

    bool ready() const { return m_encrypt.ready() && m_decrypt.ready() && m_ivs.ready(); }

    static std::size_t bodySize(std::size_t n) { return (n / kCbcBlock + 1) * kCbcBlock; }
    static std::optional<std::size_t> capacity(std::size_t room)
    {
        return room < kCbcBlock ? std::nullopt : std::optional(room / kCbcBlock * kCbcBlock - 1);
    }

    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView out)
    {
        if (!plaintext.empty() && plaintext.data() != out.data())
            std::memcpy(out.data(), plaintext.data(), plaintext.size());
        const std::size_t padding = out.size() - plaintext.size();
        std::memset(out.data() + plaintext.size(), static_cast<int>(padding), padding);
        const std::uint8_t *iv = m_ivs.at(counter);
        return iv && m_encrypt.encrypt(iv, out);
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        if (body.empty() || body.size() % kCbcBlock != 0)
            return std::nullopt;
        const std::uint8_t *iv = m_ivs.at(counter);
        if (!iv || !m_decrypt.decrypt(iv, body))
            return std::nullopt;
        // The tag was correct, so only a faulty peer sends bad padding. That makes it no padding oracle, but there is no
        // plaintext to return either.
        const std::size_t padding = body.back();
        std::uint8_t wrong = static_cast<std::uint8_t>((padding == 0) | (padding > kCbcBlock));
        for (std::size_t i = 0; i < kCbcBlock; ++i) {
            const auto inPadding = static_cast<std::uint8_t>(0 - static_cast<unsigned>(i < padding));
            wrong = static_cast<std::uint8_t>(wrong | (inPadding & (body[body.size() - 1 - i] ^ padding)));
        }
        if (declassified(wrong) != 0 && !weakened(Weakness::PaddingAccepted)) {
            sodium_memzero(body.data(), body.size());
            return std::nullopt;
        }
        return declassified(body.size() - padding);
    }

private:
    CbcChain m_encrypt;
    CbcChain m_decrypt;
    CbcIvs m_ivs;
};

using Block = std::array<std::uint8_t, kCbcBlock>;

/// For frames that are sealed in place: the ciphertext is as long as the plaintext.
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

SuiteInfo aes256CbcSuite()
{
    return {
        .id = SuiteId::Aes256Cbc,
        .name = "aes-256-cbc",
        .displayName = "AES-256-CBC",
        .strength = SuiteStrength::PaddedWithHmac,
        .blockSize = kCbcBlock,
        .color = 0xCC79A7,
        .makeRecord = EncryptThenMac<Aes256CbcBody>::make<SuiteId::Aes256Cbc>,
        .makeInline = InlineThenMac<Aes256CbcStealing>::make<SuiteId::Aes256Cbc>,
        .primitives = {.cipher = OpensslCipher{.name = "AES-256-CBC"}, .authentication = HmacSha256Tag()},
        .knownRecord =
            "e20a0cbc3fb123feb7f84b171eb4ee4633143d0295823ed8915e5b66a6636b56a86b9f3147431c578564a4bbad3b7546b51005ce"
            "51714ceceaa2807cc551900a",
    };
}

} // namespace skyseal::crypto
