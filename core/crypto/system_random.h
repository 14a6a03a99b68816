// The operating system's randomness, which the programs pass to the protocol classes.
#pragma once

#include "core/base/random_source.h"

namespace skyseal::crypto {

/// libsodium's randombytes (getrandom on Linux). Thread-safe.
class SystemRandom final : public RandomSource
{
public:
    void fill(MutableByteView out) override;
};

} // namespace skyseal::crypto
