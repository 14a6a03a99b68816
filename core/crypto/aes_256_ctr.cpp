// AES-256 in counter mode (NIST SP 800-38A 6.5), then HMAC.
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/evp.h"
#include "core/crypto/inline_then_mac.h"
#include "core/crypto/suite_factories.h"

namespace skyseal::crypto {

namespace {

/// The key stream of a short record is made by encrypting the counter blocks, which is what the mode is: OpenSSL's own counter
/// mode has to be set up anew for each record, and that takes longer than a short record itself. A long one is worth it where
/// there are no AES instructions: the counter mode, and it alone, makes eight blocks at a time there.
class Aes256CtrBody : public SameLength
{
public:
    explicit Aes256CtrBody(const RecordKeys &keys) : m_nonces(keys.iv)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-ECB", nullptr));
        static const EvpCipher bulkCipher(EVP_CIPHER_fetch(nullptr, "AES-256-CTR", nullptr));
        m_context = makeEvpContext(cipher.get(), keys.key.view().data(), EvpDirection::Encrypt);
        m_bulk = makeEvpContext(bulkCipher.get(), keys.key.view().data(), EvpDirection::Encrypt);
    }
    ~Aes256CtrBody() { sodium_memzero(m_stream.data(), m_stream.size()); }

    bool ready() const { return m_context && m_bulk; }

    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView out)
    {
        return crypt(counter, plaintext, out.data());
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        return crypt(counter, body, body.data()) ? std::optional(body.size()) : std::nullopt;
    }

private:
    static constexpr std::size_t kBlock = 16;
    static constexpr std::size_t kShort = 7 * kBlock;

    bool crypt(std::uint64_t counter, ByteView in, std::uint8_t *out)
    {
        const Nonce12 nonce = m_nonces.at(counter);
        return in.size() <= kShort ? cryptShort(nonce, in, out) : cryptLong(nonce, in, out);
    }

    bool cryptShort(const Nonce12 &nonce, ByteView in, std::uint8_t *out)
    {
        std::uint8_t *const stream = m_stream.data();
        std::uint32_t block = 0;
        std::size_t size = 0;
        for (; size < in.size(); size += kBlock) {
            std::memcpy(stream + size, nonce.data(), nonce.size());
            storeBigEndian32(stream + size + nonce.size(), block++);
        }
        int written = 0;
        if (EVP_EncryptUpdate(m_context.get(), stream, &written, stream, static_cast<int>(size)) != 1)
            return false;
        for (std::size_t i = 0; i < in.size(); ++i)
            out[i] = in[i] ^ m_stream[i];
        return true;
    }

    bool cryptLong(const Nonce12 &nonce, ByteView in, std::uint8_t *out)
    {
        std::array<std::uint8_t, kBlock> first{};
        std::copy(nonce.begin(), nonce.end(), first.begin());
        int written = 0;
        return EVP_EncryptInit_ex2(m_bulk.get(), nullptr, nullptr, first.data(), nullptr) == 1
               && EVP_EncryptUpdate(m_bulk.get(), out, &written, in.data(), static_cast<int>(in.size())) == 1;
    }

    EvpContext m_context, m_bulk;
    NonceBase m_nonces;
    std::array<std::uint8_t, kShort> m_stream{};
};

} // namespace

std::unique_ptr<RecordCipher> makeAes256Ctr(const RecordKeys &keys)
{
    return EncryptThenMac<Aes256CtrBody>::make(SuiteId::Aes256Ctr, keys);
}

std::unique_ptr<InlineCipher> makeInlineAes256Ctr(const RecordKeys &keys)
{
    return InlineThenMac<Aes256CtrBody>::make(SuiteId::Aes256Ctr, keys);
}

} // namespace skyseal::crypto
