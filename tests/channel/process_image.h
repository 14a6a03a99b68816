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
        return countWhere(maskedSecret, [](bool) { return true; });
    }
    /// The same outside of pages that are locked into memory.
    std::size_t countUnlocked(const Bytes &maskedSecret)
    {
        return countWhere(maskedSecret, [](bool locked) { return !locked; });
    }

    /// Whether the page of this address is locked into memory.
    static bool isLocked(const void *address)
    {
        const auto wanted = reinterpret_cast<std::uintptr_t>(address);
        bool out = false;
        forEachRegion(
            [&](const Region &region) { out = out || (region.from <= wanted && wanted < region.to && region.locked); });
        return out;
    }

private:
    struct Region
    {
        std::uintptr_t from = 0, to = 0;
        bool writable = false, locked = false;
    };

    /// The entries of /proc/self/smaps: a line "from-to rights …", then lines "Name: value", the last of them VmFlags.
    template<typename Call> static void forEachRegion(Call &&call)
    {
        std::ifstream maps("/proc/self/smaps");
        Region region;
        for (std::string line; std::getline(maps, line);) {
            std::istringstream words(line);
            if (line.rfind("VmFlags:", 0) == 0) {
                region.locked = line.find(" lo") != std::string::npos;
                call(region);
                continue;
            }
            char dash = 0;
            std::string rights;
            std::uintptr_t from = 0, to = 0;
            if (words >> std::hex >> from >> dash >> to >> rights && dash == '-')
                region = {from, to, rights.rfind("rw", 0) == 0, false};
        }
    }

    template<typename Wanted> std::size_t countWhere(const Bytes &maskedSecret, Wanted &&wanted)
    {
        std::size_t found = 0;
        forEachRegion([&](const Region &region) {
            if (region.writable && region.to - region.from < kLargest && wanted(region.locked))
                found += countIn(region.from, region.to, maskedSecret);
        });
        std::memset(m_chunk, 0, sizeof m_chunk);
        return found;
    }

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
