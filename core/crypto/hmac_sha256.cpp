#include "core/crypto/hmac_sha256.h"

#include "core/base/secret_bytes.h"
#include "core/crypto/locked_allocations.h"

#include <openssl/core_names.h>

#include <algorithm>
#include <array>

namespace skyseal::crypto {

/// Fetched once: looking an algorithm up by its name is the slow part of EVP.
static EVP_MAC *hmac()
{
    static const std::unique_ptr<EVP_MAC, decltype(&EVP_MAC_free)> algorithm(EVP_MAC_fetch(nullptr, "HMAC", nullptr),
                                                                             &EVP_MAC_free);
    return algorithm.get();
}

HmacSha256::HmacSha256(ByteView key)
{
    EVP_MAC *const algorithm = hmac(); // before the lock, since the first fetch loads much of OpenSSL
    const LockedAllocations locked;
    if (algorithm)
        m_context.reset(EVP_MAC_CTX_new(algorithm));
    char digest[] = "SHA256";
    const std::array parameters{OSSL_PARAM_construct_utf8_string(OSSL_MAC_PARAM_DIGEST, digest, 0), OSSL_PARAM_construct_end()};
    static constexpr std::uint8_t kNoKey = 0; // OpenSSL takes a null pointer for "keep the key"
    if (m_context && EVP_MAC_init(m_context.get(), key.empty() ? &kNoKey : key.data(), key.size(), parameters.data()) != 1)
        m_context.reset();
}

bool HmacSha256::compute(MutableByteView out, std::initializer_list<ByteView> parts)
{
    SecretBytes<kSha256Length> mac; // may become a key
    std::size_t length = 0;
    bool done = m_context && EVP_MAC_init(m_context.get(), nullptr, 0, nullptr) == 1;
    for (const ByteView part : parts)
        done = done && EVP_MAC_update(m_context.get(), part.data(), part.size()) == 1;
    done = done && EVP_MAC_final(m_context.get(), mac.mutableView().data(), &length, mac.size()) == 1;
    const std::size_t size = std::min(out.size(), mac.size());
    if (done)
        std::copy_n(mac.view().begin(), size, out.begin());
    else
        std::fill_n(out.begin(), size, std::uint8_t(0));
    return done;
}

} // namespace skyseal::crypto
