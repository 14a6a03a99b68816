#include "core/crypto/system_random.h"
#include "core/crypto/hmac_sha256.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/locked_allocations.h"

#include <sodium.h>

#include <array>

namespace skyseal::crypto {

/// Test case 2 of RFC 4231, twice with one object: before 3.0.3, OpenSSL did not begin anew with the second message.
static bool isHmacRight()
{
    constexpr std::string_view kKey = "Jefe", kData = "what do ya want for nothing?";
    constexpr std::array<std::uint8_t, kSha256Length> kExpected{
        0x5b, 0xdc, 0xc1, 0x46, 0xbf, 0x60, 0x75, 0x4e, 0x6a, 0x04, 0x24, 0x26, 0x08, 0x95, 0x75, 0xc7,
        0x5a, 0x00, 0x3f, 0x08, 0x9d, 0x27, 0x39, 0x83, 0x9d, 0xec, 0x58, 0xb9, 0x64, 0xec, 0x38, 0x43};
    HmacSha256 hmac(asBytes(kKey));
    std::array<std::uint8_t, kSha256Length> first, second;
    return hmac.compute(first, {asBytes(kData)}) && hmac.compute(second, {asBytes(kData)}) && first == kExpected
        && second == kExpected;
}

bool initCrypto()
{
    // Where another library has used OpenSSL before, key schedules stay in pages that are not locked.
    [[maybe_unused]] static const bool locks = LockedAllocations::install();
    return sodium_init() >= 0 && isHmacRight();
}

void SystemRandom::fill(MutableByteView out)
{
    randombytes_buf(out.data(), out.size());
}

} // namespace skyseal::crypto
