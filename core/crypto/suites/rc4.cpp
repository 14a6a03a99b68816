// RC4 with a separate key for each record, then HMAC. The cipher is broken nevertheless (RFC 7465); it is offered for
// measurements only.
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/inline_then_mac.h"
#include "core/crypto/rc4_stream.h"

namespace skyseal::crypto {

namespace {

class Rc4Body : public SameLength
{
public:
    explicit Rc4Body(const RecordKeys &keys) : m_keys(keys.key.view()) {}

    bool ready() const { return m_keys.ready() && m_stream.ready(); }

    bool encrypt(std::uint64_t counter, ByteView plaintext, MutableByteView out)
    {
        std::array<std::uint8_t, 8> message;
        storeLittleEndian64(message.data(), counter);
        Key32 key;
        return m_keys.compute(key.mutableView(), {message}) && m_stream.crypt(key, plaintext, out.data());
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

SuiteInfo rc4Suite()
{
    return {
        .id = SuiteId::Rc4,
        .name = "rc4",
        .displayName = "RC4",
        .strength = SuiteStrength::Broken,
        .research = true,
        .color = 0xD55E00,
        .makeRecord = EncryptThenMac<Rc4Body>::make<SuiteId::Rc4>,
        .makeInline = InlineThenMac<Rc4Body>::make<SuiteId::Rc4>,
        .primitives = {.cipher = OpensslCipher{.name = "RC4",
                                               .legacy = true,
                                               .keyedPerRecord = true,
                                               .discardedBytes = Rc4Stream::kDropped},
                       .authentication = HmacSha256Tag()},
        .knownRecord =
            "2d4c1aa5815b474f9df787f703cad8c67099147f2bf8ec94147cc49401e73a0a44bece883f2f73f1d2437140c2accc88a32ef784"
            "4cd3f6b2efcb76e9cd",
    };
}

} // namespace skyseal::crypto
