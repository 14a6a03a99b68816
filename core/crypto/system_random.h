// The operating system's randomness, as handed to the protocol classes by the programs.
#pragma once

#include "core/base/random_source.h"

namespace skyseal::crypto {

/// libsodium's randombytes (getrandom on Linux). Any thread.
class SystemRandom final : public RandomSource
{
public:
    void fill(MutableByteView out) override;
};

} // namespace skyseal::crypto
