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

void xorBlock(std::uint8_t *block, const std::uint8_t *other)
{
    std::array<std::uint64_t, 2> a, b;
    std::memcpy(a.data(), block, kBlock);
    std::memcpy(b.data(), other, kBlock);
    a[0] ^= b[0];
    a[1] ^= b[1];
    std::memcpy(block, a.data(), kBlock);
}

/// One direction of the mode over many records. To set an IV in OpenSSL takes longer than a short record itself, so the
/// chain simply goes on inside the library, and the first block of each record is corrected: the library adds the last
/// ciphertext block of the record before, which is known, where the IV is wanted.
class CbcChain
{
public:
    CbcChain(const Key32 &key, EvpDirection direction)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-CBC", nullptr));
        m_context = makeEvpContext(cipher.get(), key.view().data(), direction);
        if (m_context && !restart())
            m_context.reset();
    }

    bool ready() const { return m_context != nullptr; }

    /// Whole blocks, at least one, in place.
    bool encrypt(const std::uint8_t *iv, MutableByteView blocks)
    {
        xorBlock(blocks.data(), iv);
        xorBlock(blocks.data(), m_last.data());
        if (!update(blocks))
            return false;
        std::memcpy(m_last.data(), blocks.data() + blocks.size() - kBlock, kBlock);
        return true;
    }

    bool decrypt(const std::uint8_t *iv, MutableByteView blocks)
    {
        const std::array<std::uint8_t, kBlock> before = m_last;
        std::memcpy(m_last.data(), blocks.data() + blocks.size() - kBlock, kBlock);
        if (!update(blocks))
            return false;
        xorBlock(blocks.data(), before.data());
        xorBlock(blocks.data(), iv);
        return true;
    }

private:
    bool update(MutableByteView blocks)
    {
        int written = 0;
        const int size = static_cast<int>(blocks.size());
        return (EVP_CipherUpdate(m_context.get(), blocks.data(), &written, blocks.data(), size) == 1 && written == size)
            || (restart(), false);
    }

    bool restart()
    {
        m_last.fill(0);
        return EVP_CipherInit_ex2(m_context.get(), nullptr, nullptr, m_last.data(), -1, nullptr) == 1;
    }

    EvpContext m_context;
    std::array<std::uint8_t, kBlock> m_last{}; ///< what the library adds to the next block
};

class Aes256CbcBody
{
public:
    explicit Aes256CbcBody(const RecordKeys &keys)
        : m_encrypt(keys.key, EvpDirection::Encrypt), m_decrypt(keys.key, EvpDirection::Decrypt), m_ivs(keys.iv)
    {
    }

    bool ready() const { return m_encrypt.ready() && m_decrypt.ready() && m_ivs.ready(); }

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
        return iv && m_encrypt.encrypt(iv, out);
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        if (body.empty() || body.size() % kBlock != 0)
            return std::nullopt;
        const std::uint8_t *iv = m_ivs.at(counter);
        if (!iv || !m_decrypt.decrypt(iv, body))
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
    CbcChain m_encrypt;
    CbcChain m_decrypt;
    CbcIvs m_ivs;
};

} // namespace

std::unique_ptr<RecordCipher> makeAes256Cbc(const RecordKeys &keys)
{
    return EncryptThenMac<Aes256CbcBody>::make(SuiteId::Aes256Cbc, keys);
}

} // namespace skyseal::crypto
