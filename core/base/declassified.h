// Marks the few places where something that was computed from secrets becomes known: whether a tag was right, how long a
// plaintext is. To the compiler it is the value itself. A test build follows secrets through the machine with Valgrind and is
// told here that what comes now may decide a branch; any other branch on a secret is an error there.
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
