// Repeatable randomness for tests, from a seed that they print.
#pragma once

#include "core/base/random_source.h"

#include <random>

namespace skyseal::test {

class SeededRandom final : public RandomSource
{
public:
    explicit SeededRandom(std::uint64_t seed) : m_engine(seed) {}

    void fill(MutableByteView out) override
    {
        for (std::uint8_t &byte : out)
            byte = static_cast<std::uint8_t>(m_engine());
    }

    Bytes bytes(std::size_t count)
    {
        Bytes out(count);
        fill(out);
        return out;
    }

    std::uint64_t number() { return m_engine(); }

private:
    std::mt19937_64 m_engine;
};

} // namespace skyseal::test
