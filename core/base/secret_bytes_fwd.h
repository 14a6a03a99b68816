// Declares the secrets of secret_bytes.h, for headers that only name them.
#pragma once

#include <cstddef>

namespace skyseal {

template<std::size_t N> class SecretBytes;
using Key32 = SecretBytes<32>;

} // namespace skyseal
