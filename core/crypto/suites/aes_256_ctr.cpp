// AES-256 in counter mode (NIST SP 800-38A 6.5), then HMAC.
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/evp.h"
#include "core/crypto/inline_then_mac.h"

#include <sodium.h>

namespace skyseal::crypto {

namespace {

/// Computes the key stream by encrypting the counter blocks, which is the definition of the mode. OpenSSL's counter mode must
/// be set up again for each record, which takes longer than a short record itself.
class Aes256CtrBody : public SameLength
{
public:
    explicit Aes256CtrBody(const RecordKeys &keys) : m_nonces(keys.iv)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-ECB", nullptr));
        m_context = makeEvpContext(cipher.get(), keys.key.view().data(), EvpDirection::Encrypt);
    }
    ~Aes256CtrBody() { sodium_memzero(m_stream.data(), m_stream.size()); }

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
    static constexpr std::size_t kBlock = 16;
    static constexpr std::size_t kPiece = 32 * kBlock; ///< more than a record of one frame

    bool crypt(std::uint64_t counter, ByteView in, std::uint8_t *out)
    {
        const Nonce12 nonce = m_nonces.at(counter);
        std::uint32_t block = 0;
        for (std::size_t done = 0; done < in.size(); done += kPiece) {
            const std::size_t size = std::min(in.size() - done, kPiece);
            const std::size_t streamSize = (size + kBlock - 1) / kBlock * kBlock;
            for (std::size_t at = 0; at < streamSize; at += kBlock) {
                std::memcpy(m_stream.data() + at, nonce.data(), nonce.size());
                storeBigEndian32(m_stream.data() + at + nonce.size(), block++);
            }
            int written = 0;
            std::uint8_t *const stream = m_stream.data();
            if (EVP_EncryptUpdate(m_context.get(), stream, &written, stream, static_cast<int>(streamSize)) != 1)
                return false;
            for (std::size_t i = 0; i < size; ++i)
                out[done + i] = in[done + i] ^ m_stream[i];
        }
        return true;
    }

    EvpContext m_context;
    NonceBase m_nonces;
    std::array<std::uint8_t, kPiece> m_stream{};
};

} // namespace

SuiteInfo aes256CtrSuite()
{
    return {
        .id = SuiteId::Aes256Ctr,
        .name = "aes-256-ctr",
        .displayName = "AES-256-CTR",
        .strength = SuiteStrength::CipherWithHmac,
        .color = 0x56B4E9,
        .makeRecord = EncryptThenMac<Aes256CtrBody>::make<SuiteId::Aes256Ctr>,
        .makeInline = InlineThenMac<Aes256CtrBody>::make<SuiteId::Aes256Ctr>,
        .primitives = {.cipher = OpensslCipher{.name = "AES-256-CTR"}, .authentication = HmacSha256Tag()},
        .knownRecord =
            "37429b31379a0198cfecd693b06ade651050d5691926ace2a8d967af6231d5220277f01f7a57092ecb74c99d240115bb24f51d42"
            "f8d95f55d59785c126",
    };
}

} // namespace skyseal::crypto
