// HMAC from the compression function of OpenSSL's SHA-256. Measured alternatives, sealing records of 9 to 64 bytes relative to
// the bare library calls (core/BENCHMARKS.md; limit 1.15 for a complete record):
//                                             aes-256-ctr   aes-256-cbc   chacha20    rc4
//   this code                                 0.72-0.90     0.63-0.72     0.98-0.99   1.03-1.09
//   copied SHA256_CTX, library update, final  0.75-0.93     0.67-0.77     1.05-1.10   1.02-1.07
//   copied crypto_auth_hmacsha256_state       2.3-3.0       2.1-2.3       2.7-3.1     2.5-2.8
// libsodium's SHA-256 does not use the CPU's SHA instructions. With SHA256_Update and SHA256_Final the complete chacha20
// record, at 1.07 to 1.09 with this code, would be at the limit or above. OpenSSL deprecates SHA256_* in favor of EVP, whose
// contexts cannot be copied without an allocation.
#define OPENSSL_SUPPRESS_DEPRECATED
#include "core/crypto/hmac_sha256.h"

#include "core/base/secret_bytes.h"
#include "core/base/weakness.h"
#include "core/crypto/store_integer.h"

#include <openssl/sha.h>
#include <sodium.h>

#include <algorithm>
#include <cstring>

namespace skyseal::crypto {

namespace {

constexpr std::size_t kBlock = SHA256_CBLOCK;
static_assert(std::tuple_size_v<HmacSha256::Block> == kBlock);

/// As sodium_memzero(), without a call: these few bytes are wiped for each record. The compiler must assume that the barrier
/// reads them.
template<typename T> void wipe(T &value)
{
    std::memset(&value, 0, sizeof value);
    __asm__ __volatile__("" : : "r"(&value) : "memory");
}

/// The inner digest, padded as the end of a two-block message: the only block the outer hash has to compress.
HmacSha256::Block outerBlock(const std::uint32_t *innerDigest)
{
    // Copied whole: the hash reads 16 bytes at a time, and stalls on those that were just written in several stores.
    static constexpr std::array<std::uint8_t, kBlock - SHA256_DIGEST_LENGTH> kPadding = [] {
        std::array<std::uint8_t, kBlock - SHA256_DIGEST_LENGTH> out{0x80};
        constexpr std::size_t kBits = (kBlock + SHA256_DIGEST_LENGTH) * 8;
        out[out.size() - 2] = kBits >> 8;
        out[out.size() - 1] = kBits & 0xff;
        return out;
    }();
    HmacSha256::Block block;
    for (std::size_t i = 0; i < 8; ++i)
        storeBigEndian32(block.data() + 4 * i, innerDigest[i]);
    std::memcpy(block.data() + SHA256_DIGEST_LENGTH, kPadding.data(), kPadding.size());
    return block;
}

/// SHA-256 that continues from the state after one whole block. `block` holds what is not compressed yet, now `used` bytes.
class Continuation
{
public:
    Continuation(const std::array<std::uint32_t, 8> &state, HmacSha256::Block &block, std::size_t used = 0)
        : m_block(block.data()), m_used(used), m_length(kBlock + used)
    {
        std::copy(state.begin(), state.end(), m_context.h);
        m_context.Nl = m_context.Nh = m_context.num = 0;
        m_context.md_len = SHA256_DIGEST_LENGTH;
    }

    void add(ByteView data)
    {
        if (data.empty())
            return;
        m_length += data.size();
        if (m_used > 0) {
            const std::size_t count = std::min(data.size(), kBlock - m_used);
            std::memcpy(m_block + m_used, data.data(), count);
            m_used += count;
            data = data.subspan(count);
            if (m_used < kBlock)
                return;
            SHA256_Transform(&m_context, m_block);
            m_used = 0;
        }
        if (const std::size_t whole = data.size() / kBlock * kBlock; whole > 0) {
            SHA256_Update(&m_context, data.data(), whole); // nothing is buffered, so the library compresses them directly
            data = data.subspan(whole);
        }
        if (!data.empty()) {
            std::memcpy(m_block, data.data(), data.size());
            m_used = data.size();
        }
    }

    /// Pads and compresses the last block; the digest is then in words().
    void finish()
    {
        m_block[m_used++] = 0x80;
        if (m_used > kBlock - 8) {
            std::memset(m_block + m_used, 0, kBlock - m_used);
            SHA256_Transform(&m_context, m_block);
            m_used = 0;
        }
        std::memset(m_block + m_used, 0, kBlock - 8 - m_used);
        storeBigEndian64(m_block + kBlock - 8, m_length * 8);
        SHA256_Transform(&m_context, m_block);
    }

    const std::uint32_t *words() const { return m_context.h; }

private:
    SHA256_CTX m_context;
    std::uint8_t *m_block;
    std::size_t m_used;
    std::uint64_t m_length;
};

} // namespace

HmacSha256::HmacSha256(ByteView key)
{
    SecretBytes<kBlock> pad;
    if (key.size() > kBlock)
        SHA256(key.data(), key.size(), pad.mutableView().data());
    else
        std::copy(key.begin(), key.end(), pad.mutableView().begin());

    const auto stateAfter = [&pad](std::uint8_t value, State &state) {
        SecretBytes<kBlock> block;
        for (std::size_t i = 0; i < kBlock; ++i)
            block.mutableView()[i] = static_cast<std::uint8_t>(pad.view()[i] ^ value);
        SHA256_CTX context;
        SHA256_Init(&context);
        SHA256_Update(&context, block.view().data(), kBlock);
        std::copy_n(context.h, state.size(), state.begin());
        sodium_memzero(&context, sizeof context);
    };
    stateAfter(0x36, m_inner);
    stateAfter(0x5c, m_outer);
}

HmacSha256::~HmacSha256()
{
    if (weakened(Weakness::NoWipe))
        return;
    sodium_memzero(m_inner.data(), sizeof m_inner);
    sodium_memzero(m_outer.data(), sizeof m_outer);
}

void HmacSha256::compute(MutableByteView out, std::initializer_list<ByteView> parts) const
{
    Block block;
    Continuation inner(m_inner, block);
    for (const ByteView part : parts)
        inner.add(part);
    inner.finish();
    finish(out, inner.words());
}

void HmacSha256::compute(MutableByteView out, Block &block, std::size_t used, ByteView rest) const
{
    Continuation inner(m_inner, block, used);
    inner.add(rest);
    inner.finish();
    finish(out, inner.words());
}

void HmacSha256::finish(MutableByteView out, const std::uint32_t *innerDigest) const
{
    SHA256_CTX outer;
    std::copy(m_outer.begin(), m_outer.end(), outer.h);
    const Block block = outerBlock(innerDigest);
    SHA256_Transform(&outer, block.data());
    std::array<std::uint8_t, kSha256Length> digest;
    for (std::size_t i = 0; i < 8; ++i)
        storeBigEndian32(digest.data() + 4 * i, outer.h[i]);
    std::memcpy(out.data(), digest.data(), std::min(out.size(), digest.size()));
    // The inner digest on the stack does not reveal a key; the output of the outer hash may itself be one.
    wipe(digest);
    wipe(outer.h);
}

void hmacSha256(MutableByteView out, ByteView key, std::initializer_list<ByteView> parts)
{
    HmacSha256(key).compute(out, parts);
}

} // namespace skyseal::crypto
