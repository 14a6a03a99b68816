// How tests of files look at an error.
#pragma once

#include "core/base/result.h"

#include <string>

namespace skyseal::test {

/// The error of a result as text, "" if there is none.
template<typename T> std::string errorOf(const Result<T, InputError> &result)
{
    return result ? std::string() : result.error().text();
}

inline bool contains(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

} // namespace skyseal::test
