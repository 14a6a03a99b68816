// Blocks of bytes as one.
#pragma once

#include "core/base/bytes.h"

#include <initializer_list>

namespace skyseal::test {

template<typename Blocks> Bytes joined(const Blocks &blocks)
{
    Bytes out;
    for (const auto &block : blocks)
        out.insert(out.end(), block.begin(), block.end());
    return out;
}

inline Bytes joined(std::initializer_list<Bytes> blocks)
{
    return joined<std::initializer_list<Bytes>>(blocks);
}

} // namespace skyseal::test
