// ChaCha20 (RFC 8439 2.4) through libsodium, then HMAC.
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/inline_then_mac.h"
#include "core/crypto/suite_factories.h"

namespace skyseal::crypto {

namespace {

class ChaCha20Body : public SameLength
{
public:
    explicit ChaCha20Body(const RecordKeys &keys) : m_key(keys.key.clone()), m_nonces(keys.iv) {}

    bool ready() const { return true; }

    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView out)
    {
        if (plaintext.empty()) // libsodium declares its pointers non-null
            return true;
        const Nonce12 nonce = m_nonces.at(counter);
        return crypto_stream_chacha20_ietf_xor(out.data(), plaintext.data(), plaintext.size(), nonce.data(),
                                               m_key.view().data())
            == 0;
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        return encrypt(counter, body, body) ? std::optional(body.size()) : std::nullopt;
    }

private:
    Key32 m_key;
    NonceBase m_nonces;
};

} // namespace

std::unique_ptr<RecordCipher> makeChaCha20(const RecordKeys &keys)
{
    return EncryptThenMac<ChaCha20Body>::make(SuiteId::ChaCha20, keys);
}

std::unique_ptr<InlineCipher> makeInlineChaCha20(const RecordKeys &keys)
{
    return InlineThenMac<ChaCha20Body>::make(SuiteId::ChaCha20, keys);
}

} // namespace skyseal::crypto
