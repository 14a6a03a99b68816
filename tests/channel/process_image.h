// Searches the memory of this process for secrets. They are handed in masked, so that the search does not find its own
// input.
#pragma once

#include "core/base/bytes.h"

#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

#include <sys/uio.h>
#include <unistd.h>

namespace skyseal::test {

inline constexpr std::uint8_t kMask = 0xa5;

inline Bytes masked(ByteView secret)
{
    Bytes out(secret.begin(), secret.end());
    for (auto &byte : out)
        byte ^= kMask;
    return out;
}

/// How often a secret lies in the writable memory of this process: heap, stacks, data of libraries.
class ProcessImage
{
public:
    std::size_t count(const Bytes &maskedSecret)
    {
        std::size_t found = 0;
        std::ifstream maps("/proc/self/maps");
        for (std::string line; std::getline(maps, line);) {
            std::istringstream words(line);
            std::uintptr_t from = 0, to = 0;
            char dash = 0;
            std::string rights;
            words >> std::hex >> from >> dash >> to >> rights;
            if (rights.rfind("rw", 0) == 0 && to - from < kLargest)
                found += countIn(from, to, maskedSecret);
        }
        std::memset(m_chunk, 0, sizeof m_chunk);
        return found;
    }

private:
    static constexpr std::size_t kOverlap = 128;
    static constexpr std::uintptr_t kLargest = std::uintptr_t{1} << 30; ///< beyond it are a sanitizer's reservations

    std::size_t countIn(std::uintptr_t from, std::uintptr_t to, const Bytes &maskedSecret)
    {
        std::size_t found = 0;
        for (std::uintptr_t at = from; at < to; at += sizeof m_chunk - kOverlap) {
            const iovec local{m_chunk, std::min<std::size_t>(sizeof m_chunk, to - at)};
            const iovec remote{reinterpret_cast<void *>(at), local.iov_len};
            const ssize_t got = process_vm_readv(getpid(), &local, 1, &remote, 1, 0);
            if (got <= 0)
                continue;
            const auto own = reinterpret_cast<std::uintptr_t>(m_chunk);
            for (const std::uint8_t *hit = m_chunk; (hit = next(hit, m_chunk + got, maskedSecret)) != nullptr; ++hit) {
                const std::uintptr_t address = at + static_cast<std::uintptr_t>(hit - m_chunk);
                const bool repeated = at > from && address < at + kOverlap - maskedSecret.size();
                found += !repeated && !(address + maskedSecret.size() > own && address < own + sizeof m_chunk);
            }
        }
        return found;
    }

    static const std::uint8_t *next(const std::uint8_t *at, const std::uint8_t *end, const Bytes &maskedSecret)
    {
        const std::size_t length = maskedSecret.size();
        while (static_cast<std::size_t>(end - at) >= length) {
            at = static_cast<const std::uint8_t *>(
                std::memchr(at, maskedSecret[0] ^ kMask, static_cast<std::size_t>(end - at) - length + 1));
            if (!at)
                return nullptr;
            std::size_t same = 1;
            while (same < length && at[same] == (maskedSecret[same] ^ kMask))
                ++same;
            if (same == length)
                return at;
            ++at;
        }
        return nullptr;
    }

    std::uint8_t m_chunk[1 << 16];
};

} // namespace skyseal::test
