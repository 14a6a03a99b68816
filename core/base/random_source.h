// Randomness is passed in, so that a protocol run can be repeated from a seed.
#pragma once

#include "core/base/bytes.h"

namespace skyseal {

/// Fills buffers with random bytes. core/crypto/system_random.h uses the operating system's; tests use a seeded one.
class RandomSource
{
public:
    virtual ~RandomSource() = default;
    virtual void fill(MutableByteView out) = 0;
};

} // namespace skyseal
