// AES-256 in cipher block chaining over many short messages: the computation of their IVs, and a chain that OpenSSL does not
// have to set up again for each message. Included only by suites/aes_256_cbc.cpp.
#pragma once

#include "core/crypto/evp.h"
#include "core/crypto/record_keys.h"

#include <array>
#include <cstring>

namespace skyseal::crypto {

inline constexpr std::size_t kCbcBlock = 16;

/// The IVs of one direction, computed in groups: records mostly come in order, and a call costs more than a block.
class CbcIvs
{
public:
    explicit CbcIvs(const Key32 &key)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-ECB", nullptr));
        m_context = makeEvpContext(cipher.get(), key.view().data(), EvpDirection::Encrypt);
    }

    bool ready() const { return m_context != nullptr; }

    /// The IV of a record, valid until the next call; null if the library fails.
    const std::uint8_t *at(std::uint64_t counter)
    {
        const std::uint64_t group = counter / kGroup;
        if (!m_valid || group != m_group) {
            m_valid = false;
            m_ivs.fill(0);
            for (std::size_t i = 0; i < kGroup; ++i)
                storeBigEndian64(m_ivs.data() + i * kCbcBlock + 8, group * kGroup + i);
            int written = 0;
            if (EVP_EncryptUpdate(m_context.get(), m_ivs.data(), &written, m_ivs.data(), static_cast<int>(m_ivs.size())) != 1)
                return nullptr;
            m_group = group;
            m_valid = true;
        }
        return m_ivs.data() + (counter % kGroup) * kCbcBlock;
    }

private:
    static constexpr std::size_t kGroup = 8;

    EvpContext m_context;
    std::array<std::uint8_t, kGroup * kCbcBlock> m_ivs{};
    std::uint64_t m_group = 0;
    bool m_valid = false;
};

inline void xorCbcBlock(std::uint8_t *block, const std::uint8_t *other)
{
    std::array<std::uint64_t, 2> a, b;
    std::memcpy(a.data(), block, kCbcBlock);
    std::memcpy(b.data(), other, kCbcBlock);
    a[0] ^= b[0];
    a[1] ^= b[1];
    std::memcpy(block, a.data(), kCbcBlock);
}

/// One direction of the mode over many records. Setting an IV in OpenSSL takes longer than a short record itself. Therefore
/// the chain continues inside the library, and the first block of each record is corrected: the library xors it with the
/// last ciphertext block of the previous record, which is known, in place of the IV.
class CbcChain
{
public:
    CbcChain(const Key32 &key, EvpDirection direction)
    {
        static const EvpCipher cipher(EVP_CIPHER_fetch(nullptr, "AES-256-CBC", nullptr));
        m_context = makeEvpContext(cipher.get(), key.view().data(), direction);
        if (m_context && !restart())
            m_context.reset();
    }

    bool ready() const { return m_context != nullptr; }

    /// In place; `blocks` are whole blocks, at least one. False if the library fails.
    bool encrypt(const std::uint8_t *iv, MutableByteView blocks)
    {
        xorCbcBlock(blocks.data(), iv);
        xorCbcBlock(blocks.data(), m_last.data());
        if (!update(blocks))
            return false;
        std::memcpy(m_last.data(), blocks.data() + blocks.size() - kCbcBlock, kCbcBlock);
        return true;
    }

    bool decrypt(const std::uint8_t *iv, MutableByteView blocks)
    {
        const std::array<std::uint8_t, kCbcBlock> before = m_last;
        std::memcpy(m_last.data(), blocks.data() + blocks.size() - kCbcBlock, kCbcBlock);
        if (!update(blocks))
            return false;
        xorCbcBlock(blocks.data(), before.data());
        xorCbcBlock(blocks.data(), iv);
        return true;
    }

private:
    bool update(MutableByteView blocks)
    {
        int written = 0;
        const int size = static_cast<int>(blocks.size());
        return (EVP_CipherUpdate(m_context.get(), blocks.data(), &written, blocks.data(), size) == 1 && written == size)
            || (restart(), false);
    }

    bool restart()
    {
        m_last.fill(0);
        return EVP_CipherInit_ex2(m_context.get(), nullptr, nullptr, m_last.data(), -1, nullptr) == 1;
    }

    EvpContext m_context;
    std::array<std::uint8_t, kCbcBlock> m_last{}; ///< the library xors the next block with it
};

} // namespace skyseal::crypto
