// HKDF with SHA-256 (RFC 5869), which derives the keys of records from a handshake's output. If OpenSSL has no memory for
// an HMAC, these functions end the process, as operator new would.
#pragma once

#include "core/base/bytes.h"
#include "core/base/secret_bytes_fwd.h"

#include <string_view>

namespace skyseal::crypto {

/// HKDF-Extract: a uniform secret from key material that may not be uniform.
Key32 hkdfExtractSha256(ByteView salt, ByteView keyMaterial);

/// HKDF-Expand: fills `out`, at most 255 * 32 bytes, from a uniform secret. `info` separates the uses. Returns
/// false, with `out` unchanged, if `out` is longer.
[[nodiscard]] bool hkdfExpandSha256(MutableByteView out, ByteView secret, ByteView info);

/// The same for one key of 32 bytes, which cannot fail.
Key32 hkdfExpandKey(const Key32 &secret, ByteView info);

} // namespace skyseal::crypto
