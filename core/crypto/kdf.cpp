#include "core/crypto/kdf.h"

#include "core/base/secret_bytes.h"
#include "core/crypto/hmac_sha256.h"

#include <algorithm>
#include <cstdlib>

namespace skyseal::crypto {

/// No caller could go on without the key, and zeros in its place would be worse than the end of the process.
static void macOrAbort(HmacSha256 &hmac, Key32 &out, std::initializer_list<ByteView> parts)
{
    if (!hmac.compute(out.mutableView(), parts))
        std::abort();
}

Key32 hkdfExtractSha256(ByteView salt, ByteView keyMaterial)
{
    HmacSha256 hmac(salt);
    Key32 out;
    macOrAbort(hmac, out, {keyMaterial});
    return out;
}

bool hkdfExpandSha256(MutableByteView out, ByteView secret, ByteView info)
{
    if (out.size() > 255 * kSha256Length)
        return false;
    HmacSha256 hmac(secret);
    Key32 block;
    ByteView previous;
    std::uint8_t number = 0;
    for (std::size_t at = 0; at < out.size(); at += kSha256Length) {
        ++number;
        macOrAbort(hmac, block, {previous, info, ByteView(&number, 1)});
        previous = block.view();
        std::copy_n(previous.begin(), std::min(out.size() - at, kSha256Length), out.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return true;
}

Key32 hkdfExpandKey(const Key32 &secret, ByteView info)
{
    Key32 out;
    static_cast<void>(hkdfExpandSha256(out.mutableView(), secret.view(), info));
    return out;
}

} // namespace skyseal::crypto
