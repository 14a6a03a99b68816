#include "core/crypto/cpace.h"

#include <sodium.h>

#include <algorithm>

namespace skyseal::crypto {

namespace {

constexpr std::size_t kShareStack = 4096; ///< below a call, where the library may leave parts of a secret
constexpr std::size_t kHashBlock = 128;   ///< of SHA-512

/// SHA-512 over strings that are preceded by their length as LEB128 (the draft's lv_cat).
class LengthValueHash
{
public:
    LengthValueHash() { crypto_hash_sha512_init(&m_state); }
    ~LengthValueHash() { sodium_memzero(&m_state, sizeof m_state); }
    LengthValueHash(const LengthValueHash &) = delete;
    LengthValueHash &operator=(const LengthValueHash &) = delete;

    void add(ByteView bytes)
    {
        for (std::size_t rest = bytes.size(); true; rest >>= 7) {
            const std::uint8_t seven = static_cast<std::uint8_t>((rest & 0x7f) | (rest > 0x7f ? 0x80 : 0));
            crypto_hash_sha512_update(&m_state, &seven, 1);
            if (rest <= 0x7f)
                break;
        }
        crypto_hash_sha512_update(&m_state, bytes.data(), bytes.size());
    }
    void finish(SecretBytes<64> &out) { crypto_hash_sha512_final(&m_state, out.mutableView().data()); }

private:
    crypto_hash_sha512_state m_state;
};

std::size_t encodedLength(ByteView bytes)
{
    return bytes.size() + (bytes.size() > 0x7f ? 2 : 1);
}

} // namespace

CpaceShare cpaceGenerator(const CpaceInputs &inputs)
{
    static constexpr std::string_view kDomain = "CPaceRistretto255";
    // Zeros after the passphrase, so that it fills the first block of the hash alone.
    static constexpr std::array<std::uint8_t, kHashBlock> kZeros{};
    const std::size_t used = 1 + encodedLength(inputs.passphrase) + encodedLength(asBytes(kDomain));
    LengthValueHash hash;
    hash.add(asBytes(kDomain));
    hash.add(inputs.passphrase);
    hash.add(ByteView(kZeros).first(used < kHashBlock ? kHashBlock - used : 0));
    hash.add(inputs.channel);
    hash.add(inputs.session);
    SecretBytes<64> digest;
    hash.finish(digest);
    CpaceShare out{};
    crypto_core_ristretto255_from_hash(out.data(), digest.view().data());
    sodium_stackzero(kShareStack);
    return out;
}

Cpace Cpace::begin(Role role, const CpaceInputs &inputs, RandomSource &random)
{
    Cpace out;
    out.m_role = role;
    const CpaceShare generator = cpaceGenerator(inputs);
    random.fill(out.m_scalar.mutableView());
    out.m_scalar.mutableView()[31] &= 0x0f; // 252 bits
    // Fails for a scalar of zero alone; the share of zeros is then refused by the other end.
    if (crypto_scalarmult_ristretto255(out.m_share.data(), out.m_scalar.view().data(), generator.data()) != 0)
        out.m_share = {};
    sodium_stackzero(kShareStack);
    return out;
}

std::optional<CpaceKey> Cpace::key(ByteView session, const CpaceMessage &initiator, const CpaceMessage &responder) const
{
    const ByteView theirs = m_role == Role::Initiator ? responder.share : initiator.share;
    Key32 secret;
    const bool valid = theirs.size() == secret.size()
        && crypto_scalarmult_ristretto255(secret.mutableView().data(), m_scalar.view().data(), theirs.data()) == 0;
    sodium_stackzero(kShareStack);
    if (!valid)
        return std::nullopt;
    LengthValueHash hash;
    hash.add(asBytes("CPaceRistretto255_ISK"));
    hash.add(session);
    hash.add(secret.view());
    for (const CpaceMessage &message : {initiator, responder}) {
        hash.add(message.share);
        hash.add(message.associatedData);
    }
    CpaceKey out;
    hash.finish(out);
    return out;
}

} // namespace skyseal::crypto
