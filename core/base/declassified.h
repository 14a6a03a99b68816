// Marks the few values that are computed from secrets and then become public: whether a tag was correct, the length of a
// plaintext. In shipped builds declassified() returns its argument. The constant-time test tracks secrets with Valgrind, and
// every branch on a secret that was not declassified here is an error.
#pragma once

#include <cstddef>

namespace skyseal {

#ifdef SKYSEAL_WEAKEN
void declassify(const void *bytes, std::size_t count);

template<typename T> T declassified(T value)
{
    declassify(&value, sizeof value);
    return value;
}
#else
template<typename T> constexpr T declassified(T value)
{
    return value;
}
#endif

} // namespace skyseal
