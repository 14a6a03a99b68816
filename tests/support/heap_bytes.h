#pragma once

#include <cstddef>

#include <malloc.h>

namespace skyseal::test {

/// Bytes in use on the heap; 0 where they cannot be counted.
inline std::size_t heapBytes()
{
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    const auto info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
#else
    return 0;
#endif
}

} // namespace skyseal::test
