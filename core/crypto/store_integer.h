// Stores integers as bytes on the hot paths, by one byte swap and one store. Written byte by byte, compilers emit up to
// eight small stores, and the wide load that follows in a hash or cipher stalls on them.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace skyseal::crypto {

inline void storeBigEndian32(std::uint8_t *out, std::uint32_t value)
{
    if constexpr (std::endian::native == std::endian::little)
        value = __builtin_bswap32(value);
    std::memcpy(out, &value, sizeof value);
}

inline void storeBigEndian64(std::uint8_t *out, std::uint64_t value)
{
    if constexpr (std::endian::native == std::endian::little)
        value = __builtin_bswap64(value);
    std::memcpy(out, &value, sizeof value);
}

inline void storeLittleEndian32(std::uint8_t *out, std::uint32_t value)
{
    if constexpr (std::endian::native == std::endian::big)
        value = __builtin_bswap32(value);
    std::memcpy(out, &value, sizeof value);
}

inline void storeLittleEndian64(std::uint8_t *out, std::uint64_t value)
{
    if constexpr (std::endian::native == std::endian::big)
        value = __builtin_bswap64(value);
    std::memcpy(out, &value, sizeof value);
}

} // namespace skyseal::crypto
