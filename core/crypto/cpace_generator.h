// The part of CPace (cpace.h) that needs no secret of its own: the inputs of both ends, and the generator that they give.
#pragma once

#include "core/base/bytes.h"

#include <array>

namespace skyseal::crypto {

/// An encoded element of ristretto255.
using CpaceShare = std::array<std::uint8_t, 32>;

/// The inputs of both ends. At most 1024 bytes each; the passphrase may be empty.
struct CpaceInputs
{
    ByteView passphrase; ///< PRS
    ByteView channel;    ///< CI
    ByteView session;    ///< sid
};

/// The draft's encoded generator.
CpaceShare cpaceGenerator(const CpaceInputs &inputs);

} // namespace skyseal::crypto
