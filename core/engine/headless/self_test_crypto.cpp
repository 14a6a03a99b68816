// Known answers of the ciphers and the handshake. Those of the primitives are from their standards; those of the records were
// computed by another implementation (Python's cryptography) from the description in core/crypto/record_cipher.h.
#include "core/engine/headless/self_test.h"

#include "core/base/hex.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/hash.h"
#include "core/crypto/hmac_sha256.h"
#include "core/crypto/kdf.h"
#include "core/crypto/record_cipher.h"
#include "core/crypto/x25519.h"
#include "core/noise/handshake_state.h"

#include <algorithm>
#include <array>

namespace skyseal::engine {

namespace {

Bytes hex(std::string_view text)
{
    return fromHex(text).value_or(Bytes());
}

bool same(ByteView a, ByteView b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

Key32 keyOf(std::string_view text)
{
    const Bytes bytes = hex(text);
    return Key32(std::span<const std::uint8_t, 32>(bytes.data(), 32));
}

std::optional<std::string> expect(bool right, const char *what)
{
    return right ? std::nullopt : std::optional<std::string>(what);
}

/// Inputs of the known record in each suite's descriptor: secret bytes 5i + 1, this counter, associated data
/// "skyseal self-test", 45 bytes 3i of plaintext.
constexpr std::uint64_t kCounter = 0x010203;

std::unique_ptr<crypto::RecordCipher> knownCipher(crypto::SuiteId suite)
{
    crypto::DirectionSecret secret;
    for (std::size_t i = 0; i < secret.size(); ++i)
        secret.mutableView()[i] = static_cast<std::uint8_t>(5 * i + 1);
    return crypto::makeRecordCipher(suite, std::move(secret));
}

std::optional<std::string> checkRecord(const crypto::SuiteInfo &suite)
{
    const auto cipher = knownCipher(suite.id);
    if (!cipher)
        return "not available on this machine";
    const ByteView about = asBytes("skyseal self-test");
    std::array<std::uint8_t, 45> plain;
    for (std::size_t i = 0; i < plain.size(); ++i)
        plain[i] = static_cast<std::uint8_t>(3 * i);
    Bytes record(cipher->sealedSize(plain.size()));
    record.resize(cipher->seal(kCounter, about, plain, record));
    if (!same(record, hex(suite.knownRecord)))
        return "seals to something else";
    Bytes damaged = record;
    damaged.back() ^= 1;
    if (knownCipher(suite.id)->open(kCounter, about, damaged))
        return "takes a damaged record";
    const auto opened = knownCipher(suite.id)->open(kCounter, about, record);
    return expect(opened && same(*opened, plain), "does not open what it sealed");
}

/// Fixed ephemeral keys, from the published vector.
class ChosenRandom final : public RandomSource
{
public:
    explicit ChosenRandom(Bytes bytes) : m_bytes(std::move(bytes)) {}
    void fill(MutableByteView out) override { std::copy_n(m_bytes.begin(), std::min(out.size(), m_bytes.size()), out.begin()); }

private:
    Bytes m_bytes;
};

/// The vector of the cacophony project for Noise_IKpsk2_25519_ChaChaPoly_BLAKE2b.
std::optional<std::string> checkHandshake()
{
    const ByteView prologue = asBytes("John Galt");
    auto initiatorKeys = crypto::X25519KeyPair::fromSecret(
        keyOf("e61ef9919cde45dd5f82166404bd08e38bceb5dfdfded0a34c8df7ed542214d1"));
    auto responderKeys = crypto::X25519KeyPair::fromSecret(
        keyOf("4a3acbfdb163dec651dfa3194dece676d437029c62a408b4c5ea9114246e4893"));
    const Key32 psk = keyOf("54686973206973206d7920417573747269616e20706572737065637469766521");
    auto initiator = noise::HandshakeState::initiator(prologue, std::move(initiatorKeys), responderKeys.publicKey);
    auto responder = noise::HandshakeState::responder(prologue, std::move(responderKeys));
    initiator.setPsk(psk.clone());
    responder.setPsk(psk.clone());
    ChosenRandom first(hex("893e28b9dc6ca8d611ab664754b8ceb7bac5117349a4439a6b0569da977c464a"));
    ChosenRandom second(hex("bbdb4cdbd309f1a1f2e1456967fe288cadd6f712d65dc7b7793d5e63da6b375b"));
    const ByteView firstPayload = asBytes("Ludwig von Mises"), secondPayload = asBytes("Murray Rothbard");
    Bytes message(noise::kFirstOverhead + firstPayload.size()), payload(firstPayload.size());
    const bool sent = initiator.writeMessage(firstPayload, message, first).has_value();
    const Bytes expected = hex(
        "ca35def5ae56cec33dc2036731ab14896bc4c75dbb07a61f879f8e3afa4c7944b6fe0240b839afac809de1630eaf99d8f9b941394f0512c"
        "0554633bbb021d1"
        "5176135c0a20e7fdb9a9ed066f22f054b47625b1d5061cb27d6a17f053273db7c25216a5addc506ee321bc0618feb5849d");
    if (!sent || !same(message, expected))
        return "the first message is another one";
    if (!responder.readMessage(message, payload) || !same(payload, firstPayload))
        return "the first message is refused";
    Bytes answer(noise::kSecondOverhead + secondPayload.size());
    if (!responder.writeMessage(secondPayload, answer, second) || !initiator.readMessage(answer, payload))
        return "the answer is refused";
    const auto initiators = std::move(initiator).finish(), responders = std::move(responder).finish();
    const Bytes hash = hex(
        "ed837c9084f2f0333a7ec60b9bcacd9921394858de8ced118b5966d1147ba390084dab42326c565a309c29317a6079be30aa1d790d25a517"
        "b43287426cb1d36a");
    return expect(initiators && responders && same(initiators->handshakeHash, hash) && same(responders->handshakeHash, hash),
                  "the hash is another one");
}

} // namespace

std::vector<SelfTest> primitiveSelfTests()
{
    const auto hmac = [] { // RFC 4231, case 2
        std::array<std::uint8_t, 32> out;
        const bool done = crypto::HmacSha256(asBytes("Jefe")).compute(out, {asBytes("what do ya want for nothing?")});
        return expect(done && same(out, hex("5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843")),
                      "wrong answer");
    };
    const auto hkdf = [] { // RFC 5869, case 1
        std::array<std::uint8_t, 42> out;
        const bool done = crypto::hkdfExpandSha256(out, hex("077709362c2e32df0ddc3f0dc47bba6390b6c73bb50f9c3122ec844ad7c2b3e5"),
                                                   hex("f0f1f2f3f4f5f6f7f8f9"));
        return expect(
            done && same(out, hex("3cb25f25faacd57a90434f64d0362f2a2d2d0a90cf1a5a4c5db02d56ecc4c5bf34007208d5b887185865")),
            "wrong answer");
    };
    const auto blake = [] { // RFC 7693, appendix A
        return expect(same(crypto::blake2b({asBytes("abc")}),
                           hex("ba80a53f981c4d0d6a2797b69f12f6e94c212f14685ac4b74b12bb6fd"
                               "bffa2d17d87c5392aab792dc252d5de4533cc9518d38aa8dbf192"
                               "5ab92386edd4009923")),
                      "wrong answer");
    };
    const auto x25519 = [] { // RFC 7748, 5.2
        const Bytes point = hex("e6db6867583030db3594c1a424b15f7c726624ec26b3353b10a903a6d0ab1c4c");
        crypto::PublicKey other{};
        std::copy(point.begin(), point.end(), other.begin());
        const auto shared = crypto::x25519(keyOf("a546e36bf0527c9d3b16154b82465edd62144c0ac1fc5a18506a2244ba449ac4"), other);
        return expect(shared && shared->equals(keyOf("c3da55379de9c6908e94ea4df28d084f32eccf03491c71f754b4075577a28552")),
                      "wrong answer");
    };
    return {{"HMAC-SHA-256", hmac}, {"HKDF-SHA-256", hkdf}, {"BLAKE2b", blake}, {"X25519", x25519}};
}

std::vector<SelfTest> suiteSelfTests()
{
    std::vector<SelfTest> out;
    for (const crypto::SuiteId id : crypto::sealedSuites()) {
        const crypto::SuiteInfo &suite = crypto::suiteInfo(id);
        out.push_back({"suite " + std::string(suite.name), [&suite] { return checkRecord(suite); }});
    }
    return out;
}

std::vector<SelfTest> handshakeSelfTests()
{
    return {{"Noise IKpsk2 handshake", checkHandshake}};
}

} // namespace skyseal::engine
