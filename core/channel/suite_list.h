// The ordered list of suite numbers in an offer (PROTOCOL.md, section 4.3).
//
// The field has twelve half bytes, the low half of a byte first. 1 to 14 is a short number. 15 introduces a long number,
// 15 to 255, in the next two half bytes, low half first. 0 is unused.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace skyseal::channel {

inline constexpr std::size_t kSuiteListHalves = 12;
inline constexpr std::uint8_t kFirstLongSuiteNumber = 15;

using SuiteListField = std::array<std::uint8_t, kSuiteListHalves / 2>;

/// Half bytes that a suite number takes in the list.
constexpr std::size_t suiteNumberHalves(std::uint8_t number)
{
    return number < kFirstLongSuiteNumber ? 1 : 3;
}

/// Encodes the numbers, best first, and ends before the first one that does not fit. A 0 is an unused half byte.
SuiteListField packSuiteNumbers(std::span<const std::uint8_t> numbers);

/// Decodes the numbers in their order, each once. Skips zeros, repetitions, long forms of short numbers, and a long number
/// that is cut off by the end of the field; every field is valid.
std::vector<std::uint8_t> unpackSuiteNumbers(const SuiteListField &field);

} // namespace skyseal::channel
