// AES-256 in counter mode (NIST SP 800-38A 6.5), then HMAC.
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/evp.h"
#include "core/crypto/suite_factories.h"

namespace skyseal::crypto {

namespace {

class Aes256CtrBody : public SameLength
{
public:
    explicit Aes256CtrBody(const RecordKeys &keys) : m_nonces(keys.iv)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-CTR", nullptr));
        m_context = makeEvpContext(cipher.get(), keys.key.view().data(), EvpDirection::Encrypt);
    }

    bool ready() const { return m_context != nullptr; }

    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView out)
    {
        return crypt(counter, plaintext, out.data());
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        return crypt(counter, body, body.data()) ? std::optional(body.size()) : std::nullopt;
    }

private:
    bool crypt(std::uint64_t counter, ByteView in, std::uint8_t *out)
    {
        std::array<std::uint8_t, 16> block{};
        const Nonce12 nonce = m_nonces.at(counter);
        std::memcpy(block.data(), nonce.data(), nonce.size());
        int written = 0;
        return EVP_EncryptInit_ex2(m_context.get(), nullptr, nullptr, block.data(), nullptr) == 1
            && (in.empty() || EVP_EncryptUpdate(m_context.get(), out, &written, in.data(), static_cast<int>(in.size())) == 1);
    }

    EvpContext m_context;
    NonceBase m_nonces;
};

} // namespace

std::unique_ptr<RecordCipher> makeAes256Ctr(const RecordKeys &keys)
{
    return EncryptThenMac<Aes256CtrBody>::make(SuiteId::Aes256Ctr, keys);
}

} // namespace skyseal::crypto
