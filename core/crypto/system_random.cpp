#include "core/crypto/system_random.h"
#include "core/crypto/init_crypto.h"

#include <sodium.h>

namespace skyseal::crypto {

bool initCrypto()
{
    return sodium_init() >= 0;
}

void SystemRandom::fill(MutableByteView out)
{
    randombytes_buf(out.data(), out.size());
}

} // namespace skyseal::crypto
