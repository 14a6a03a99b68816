#include "core/crypto/system_random.h"
#include "core/crypto/hmac_sha256.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/locked_allocations.h"

#include <sodium.h>

namespace skyseal::crypto {

bool initCrypto()
{
    // Where another library has used OpenSSL before, key schedules stay in pages that are not locked.
    [[maybe_unused]] static const bool locks = LockedAllocations::install();
    return sodium_init() >= 0 && HmacSha256({}).ready();
}

void SystemRandom::fill(MutableByteView out)
{
    randombytes_buf(out.data(), out.size());
}

} // namespace skyseal::crypto
