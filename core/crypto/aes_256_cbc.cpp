// AES-256 in cipher block chaining (NIST SP 800-38A 6.2) with PKCS#7 padding, then HMAC.
#include "core/crypto/cbc_chain.h"
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/suite_factories.h"

namespace skyseal::crypto {

namespace {

constexpr std::size_t kBlock = kCbcBlock;

class Aes256CbcBody
{
public:
    explicit Aes256CbcBody(const RecordKeys &keys)
        : m_encrypt(keys.key, EvpDirection::Encrypt), m_decrypt(keys.key, EvpDirection::Decrypt), m_ivs(keys.iv)
    {}

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
        // The tag was good, so only a faulty peer gets here with bad padding; it is no oracle, but it is no plaintext
        // either.
        const std::size_t padding = body.back();
        std::uint8_t wrong = static_cast<std::uint8_t>((padding == 0) | (padding > kBlock));
        for (std::size_t i = 0; i < kBlock; ++i) {
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

} // namespace

std::unique_ptr<RecordCipher> makeAes256Cbc(const RecordKeys &keys)
{
    return EncryptThenMac<Aes256CbcBody>::make(SuiteId::Aes256Cbc, keys);
}

} // namespace skyseal::crypto
