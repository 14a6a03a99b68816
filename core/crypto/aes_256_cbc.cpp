// AES-256 in cipher block chaining (NIST SP 800-38A 6.2) with PKCS#7 padding, then HMAC.
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/evp.h"
#include "core/crypto/suite_factories.h"

namespace skyseal::crypto {

namespace {

constexpr std::size_t kBlock = 16;

/// The IVs of a direction, several made with one call, since records mostly come in order and a call costs more than a block.
class CbcIvs
{
public:
    explicit CbcIvs(const Key32 &key)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-ECB", nullptr));
        m_context = makeEvpContext(cipher.get(), key.view().data(), EvpDirection::Encrypt);
    }

    bool ready() const { return m_context != nullptr; }

    /// The IV of a record, valid until the next call; null when the library failed.
    const std::uint8_t *at(std::uint64_t counter)
    {
        const std::uint64_t group = counter / kGroup;
        if (!m_valid || group != m_group) {
            m_valid = false;
            m_ivs.fill(0);
            for (std::size_t i = 0; i < kGroup; ++i)
                storeBigEndian64(m_ivs.data() + i * kBlock + 8, group * kGroup + i);
            int written = 0;
            if (EVP_EncryptUpdate(m_context.get(), m_ivs.data(), &written, m_ivs.data(), static_cast<int>(m_ivs.size())) != 1)
                return nullptr;
            m_group = group;
            m_valid = true;
        }
        return m_ivs.data() + (counter % kGroup) * kBlock;
    }

private:
    static constexpr std::size_t kGroup = 8;

    EvpContext m_context;
    std::array<std::uint8_t, kGroup * kBlock> m_ivs{};
    std::uint64_t m_group = 0;
    bool m_valid = false;
};

class Aes256CbcBody
{
public:
    explicit Aes256CbcBody(const RecordKeys &keys) : m_ivs(keys.iv)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-CBC", nullptr));
        m_encrypt = makeEvpContext(cipher.get(), keys.key.view().data(), EvpDirection::Encrypt);
        m_decrypt = makeEvpContext(cipher.get(), keys.key.view().data(), EvpDirection::Decrypt);
    }

    bool ready() const { return m_encrypt && m_decrypt && m_ivs.ready(); }

    static std::size_t bodySize(std::size_t n) { return (n / kBlock + 1) * kBlock; }
    static std::optional<std::size_t> capacity(std::size_t room)
    {
        return room < kBlock ? std::nullopt : std::optional(room / kBlock * kBlock - 1);
    }

    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView out)
    {
        if (!plaintext.empty() && plaintext.data() != out.data())
            std::memcpy(out.data(), plaintext.data(), plaintext.size());
        const std::size_t padding = out.size() - plaintext.size();
        std::memset(out.data() + plaintext.size(), static_cast<int>(padding), padding);
        const std::uint8_t *iv = m_ivs.at(counter);
        int written = 0;
        return iv && EVP_EncryptInit_ex2(m_encrypt.get(), nullptr, nullptr, iv, nullptr) == 1
            && EVP_EncryptUpdate(m_encrypt.get(), out.data(), &written, out.data(), static_cast<int>(out.size())) == 1;
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        if (body.empty() || body.size() % kBlock != 0)
            return std::nullopt;
        const std::uint8_t *iv = m_ivs.at(counter);
        int written = 0;
        if (!iv || EVP_DecryptInit_ex2(m_decrypt.get(), nullptr, nullptr, iv, nullptr) != 1
            || EVP_DecryptUpdate(m_decrypt.get(), body.data(), &written, body.data(), static_cast<int>(body.size())) != 1)
            return std::nullopt;
        // The tag was good, so only a faulty peer gets here with bad padding; it is no oracle, but it is no plaintext either.
        const std::size_t padding = body.back();
        std::uint8_t wrong = static_cast<std::uint8_t>(padding == 0 || padding > kBlock);
        for (std::size_t i = 0; i < kBlock; ++i) {
            const auto inPadding = static_cast<std::uint8_t>(i < padding ? 0xff : 0);
            wrong = static_cast<std::uint8_t>(wrong | (inPadding & (body[body.size() - 1 - i] ^ padding)));
        }
        if (wrong != 0) {
            sodium_memzero(body.data(), body.size());
            return std::nullopt;
        }
        return body.size() - padding;
    }

private:
    EvpContext m_encrypt;
    EvpContext m_decrypt;
    CbcIvs m_ivs;
};

} // namespace

std::unique_ptr<RecordCipher> makeAes256Cbc(const RecordKeys &keys)
{
    return EncryptThenMac<Aes256CbcBody>::make(SuiteId::Aes256Cbc, keys);
}

} // namespace skyseal::crypto
