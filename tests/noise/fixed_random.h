// A random source with chosen bytes.
#pragma once

#include "core/base/random_source.h"

#include <algorithm>
#include <cstddef>

namespace skyseal::test {

/// Returns the given bytes in order, then zeros.
class FixedRandom final : public RandomSource
{
public:
    explicit FixedRandom(Bytes bytes) : m_bytes(std::move(bytes)) {}

    void fill(MutableByteView out) override
    {
        for (std::uint8_t &byte : out)
            byte = m_at < m_bytes.size() ? m_bytes[m_at++] : std::uint8_t(0);
    }

private:
    Bytes m_bytes;
    std::size_t m_at = 0;
};

} // namespace skyseal::test
