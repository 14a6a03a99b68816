#include "core/base/secret_bytes.h"

#include <sodium.h>

namespace skyseal {

void wipeSecret(void *bytes, std::size_t size) noexcept
{
    sodium_memzero(bytes, size);
}

bool equalSecrets(const void *a, const void *b, std::size_t size) noexcept
{
    return sodium_memcmp(a, b, size) == 0;
}

bool isZeroSecret(const void *bytes, std::size_t size) noexcept
{
    return sodium_is_zero(static_cast<const unsigned char *>(bytes), size) != 0;
}

} // namespace skyseal
