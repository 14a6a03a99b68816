// What all fuzzers with oracles of their own share: the end of a run that violates one, and the memory in use.
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include <malloc.h>

extern "C" std::size_t __sanitizer_get_current_allocated_bytes() __attribute__((weak));

namespace skyseal::test {

/// Ends the run: the oracle with this name found a violation. A weakened twin exits with an error, so that its test can read
/// the name; a fuzzer crashes.
[[noreturn]] inline void violated(const char *oracle)
{
    std::fprintf(stderr, "violated: %s\n", oracle);
#ifdef SKYSEAL_WEAKEN
    std::_Exit(1);
#else
    std::abort();
#endif
}

/// Bytes that are allocated now; 0 where the library cannot say.
inline std::size_t allocatedBytes()
{
    if (__sanitizer_get_current_allocated_bytes)
        return __sanitizer_get_current_allocated_bytes();
    return mallinfo2().uordblks;
}

/// Notices memory that a run keeps. Begins with the run, whose engine is there already.
class GrowthWatch
{
public:
    void judge() const
    {
        if (allocatedBytes() > m_before + kMost)
            violated("nothing grows");
    }

private:
    static constexpr std::size_t kMost = 1u << 20; ///< the corpora leave 0.3 MB at most, their own records included
    std::size_t m_before = allocatedBytes();
};

} // namespace skyseal::test
