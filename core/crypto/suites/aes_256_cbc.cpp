// AES-256 in cipher block chaining (NIST SP 800-38A 6.2) by OpenSSL, then HMAC. Records are padded by PKCS#7. Frames that are
// sealed in place keep their length by ciphertext stealing (CBC-CS1 of the addendum to SP 800-38A) and, below one block, by
// residual block termination; see inline_cipher.h.
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/evp.h"
#include "core/crypto/inline_then_mac.h"

#include <sodium.h>

#include <array>

namespace skyseal::crypto {

namespace {

constexpr std::size_t kBlock = 16;
using Block = std::array<std::uint8_t, kBlock>;

/// AES-256 of single blocks.
class BlockCipher
{
public:
    explicit BlockCipher(const Key32 &key)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-ECB", nullptr));
        m_context = makeEvpContext(cipher.get(), key.view().data(), EvpDirection::Encrypt);
    }

    bool ready() const { return m_context != nullptr; }

    /// In place. False if the library fails.
    bool encrypt(Block &block)
    {
        int written = 0;
        return EVP_EncryptUpdate(m_context.get(), block.data(), &written, block.data(), static_cast<int>(kBlock)) == 1;
    }

private:
    EvpContext m_context;
};

/// The IVs of one direction: the encrypted counters, which nobody can predict without the key.
class CbcIvs
{
public:
    explicit CbcIvs(const Key32 &key) : m_cipher(key) {}

    bool ready() const { return m_cipher.ready(); }

    /// Sets the IV of a record for the next message of `context`. False if the library fails.
    bool apply(std::uint64_t counter, EVP_CIPHER_CTX *context)
    {
        Block iv;
        return make(counter, iv) && EVP_CipherInit_ex2(context, nullptr, nullptr, iv.data(), -1, nullptr) == 1;
    }

    bool make(std::uint64_t counter, Block &iv)
    {
        iv.fill(0);
        storeBigEndian64(iv.data() + kBlock - sizeof counter, counter);
        return m_cipher.encrypt(iv);
    }

private:
    BlockCipher m_cipher;
};

class Aes256CbcBody
{
public:
    explicit Aes256CbcBody(const RecordKeys &keys) : m_ivs(keys.iv)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-CBC", nullptr));
        m_encrypt = makeEvpContext(cipher.get(), keys.key.view().data(), EvpDirection::Encrypt);
        m_decrypt = makeEvpContext(cipher.get(), keys.key.view().data(), EvpDirection::Decrypt);
        if (m_decrypt && EVP_CIPHER_CTX_set_padding(m_decrypt.get(), 0) != 1) // decrypt() checks it, in constant time
            m_decrypt.reset();
    }

    bool ready() const { return m_encrypt && m_decrypt && m_ivs.ready(); }

    static std::size_t bodySize(std::size_t n) { return (n / kBlock + 1) * kBlock; }
    static std::optional<std::size_t> capacity(std::size_t room)
    {
        return room < kBlock ? std::nullopt : std::optional(room / kBlock * kBlock - 1);
    }

    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView out)
    {
        int written = 0, last = 0;
        const int size = static_cast<int>(plaintext.size());
        return m_ivs.apply(counter, m_encrypt.get())
            && (size == 0 || EVP_EncryptUpdate(m_encrypt.get(), out.data(), &written, plaintext.data(), size) == 1)
            && EVP_EncryptFinal_ex(m_encrypt.get(), out.data() + written, &last) == 1
            && static_cast<std::size_t>(written) + static_cast<std::size_t>(last) == out.size();
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        if (body.empty() || body.size() % kBlock != 0)
            return std::nullopt;
        int written = 0;
        if (!m_ivs.apply(counter, m_decrypt.get())
            || EVP_DecryptUpdate(m_decrypt.get(), body.data(), &written, body.data(), static_cast<int>(body.size())) != 1
            || static_cast<std::size_t>(written) != body.size())
            return std::nullopt;
        // The tag was correct, so only a faulty peer sends bad padding. That makes it no padding oracle, but there is no
        // plaintext to return either.
        const std::size_t padding = body.back();
        std::uint8_t wrong = static_cast<std::uint8_t>((padding == 0) | (padding > kBlock));
        for (std::size_t i = 0; i < kBlock; ++i) {
            const auto inPadding = static_cast<std::uint8_t>(0 - static_cast<unsigned>(i < padding));
            wrong = static_cast<std::uint8_t>(wrong | (inPadding & (body[body.size() - 1 - i] ^ padding)));
        }
        if (declassified(wrong) != 0)
            return std::nullopt;
        return declassified(body.size() - padding);
    }

private:
    EvpContext m_encrypt;
    EvpContext m_decrypt;
    CbcIvs m_ivs;
};

/// For frames that are sealed in place: the ciphertext is as long as the plaintext.
class Aes256CbcStealing
{
public:
    explicit Aes256CbcStealing(const RecordKeys &keys) : m_residues(keys.key), m_ivs(keys.iv)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-CBC-CTS", nullptr)); // CS1 unless told otherwise
        m_encrypt = makeEvpContext(cipher.get(), keys.key.view().data(), EvpDirection::Encrypt);
        m_decrypt = makeEvpContext(cipher.get(), keys.key.view().data(), EvpDirection::Decrypt);
    }

    bool ready() const { return m_encrypt && m_decrypt && m_residues.ready() && m_ivs.ready(); }

    /// In place: `plaintext` and `body` are the same bytes.
    bool encrypt(std::uint64_t counter, ByteView, MutableByteView body)
    {
        return body.size() < kBlock ? cryptResidue(counter, body) : crypt(m_encrypt.get(), counter, body);
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        const bool done = body.size() < kBlock ? cryptResidue(counter, body) : crypt(m_decrypt.get(), counter, body);
        return done ? std::optional(body.size()) : std::nullopt;
    }

private:
    bool crypt(EVP_CIPHER_CTX *context, std::uint64_t counter, MutableByteView body)
    {
        int written = 0;
        const int size = static_cast<int>(body.size());
        return m_ivs.apply(counter, context) && EVP_CipherUpdate(context, body.data(), &written, body.data(), size) == 1
            && written == size;
    }

    bool cryptResidue(std::uint64_t counter, MutableByteView body)
    {
        Block stream;
        const bool made = m_ivs.make(counter, stream) && m_residues.encrypt(stream);
        for (std::size_t i = 0; made && i < body.size(); ++i)
            body[i] ^= stream[i];
        sodium_memzero(stream.data(), stream.size());
        return made;
    }

    EvpContext m_encrypt;
    EvpContext m_decrypt;
    BlockCipher m_residues;
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
        .blockSize = kBlock,
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
