// RC4 with a key of its own for each record, then HMAC. Broken as a cipher all the same (RFC 7465): it is here to be
// measured.
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/inline_then_mac.h"
#include "core/crypto/rc4_stream.h"
#include "core/crypto/suite_factories.h"

namespace skyseal::crypto {

namespace {

class Rc4Body : public SameLength
{
public:
    explicit Rc4Body(const RecordKeys &keys) : m_keys(keys.key.view()) {}

    bool ready() const { return m_stream.ready(); }

    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView out)
    {
        std::array<std::uint8_t, 8> message;
        storeLittleEndian64(message.data(), counter);
        Key32 key;
        m_keys.compute(key.mutableView(), {message});
        return m_stream.crypt(key, plaintext, out.data());
    }

    std::optional<std::size_t> decrypt(std::uint64_t counter, MutableByteView body)
    {
        return encrypt(counter, body, body) ? std::optional(body.size()) : std::nullopt;
    }

private:
    HmacSha256 m_keys;
    Rc4Stream m_stream;
};

} // namespace

std::unique_ptr<RecordCipher> makeRc4(const RecordKeys &keys)
{
    return EncryptThenMac<Rc4Body>::make(SuiteId::Rc4, keys);
}

std::unique_ptr<InlineCipher> makeInlineRc4(const RecordKeys &keys)
{
    return InlineThenMac<Rc4Body>::make(SuiteId::Rc4, keys);
}

} // namespace skyseal::crypto
