#include "core/channel/suite_list.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

/// Access to a field by half bytes.
std::uint8_t halfAt(const SuiteListField &field, std::size_t i)
{
    return static_cast<std::uint8_t>(i % 2 == 0 ? field[i / 2] & 15 : field[i / 2] >> 4);
}

void setHalf(SuiteListField &field, std::size_t i, unsigned value)
{
    field[i / 2] = static_cast<std::uint8_t>(field[i / 2] | (value & 15) << (i % 2 * 4));
}

} // namespace

SuiteListField packSuiteNumbers(std::span<const std::uint8_t> numbers)
{
    SuiteListField field{};
    std::size_t at = 0;
    for (const std::uint8_t number : numbers) {
        if (at + suiteNumberHalves(number) > kSuiteListHalves)
            break;
        if (number < kFirstLongSuiteNumber) {
            setHalf(field, at++, number);
            continue;
        }
        setHalf(field, at++, kFirstLongSuiteNumber);
        setHalf(field, at++, number);
        setHalf(field, at++, number >> 4);
    }
    return field;
}

std::vector<std::uint8_t> unpackSuiteNumbers(const SuiteListField &field)
{
    std::vector<std::uint8_t> numbers;
    const auto add = [&numbers](std::uint8_t number) {
        if (number != 0 && std::find(numbers.begin(), numbers.end(), number) == numbers.end())
            numbers.push_back(number);
    };
    for (std::size_t at = 0; at < kSuiteListHalves; ++at) {
        const std::uint8_t half = halfAt(field, at);
        if (half < kFirstLongSuiteNumber) {
            add(half);
        } else if (at + 2 < kSuiteListHalves) {
            const auto number = static_cast<std::uint8_t>(halfAt(field, at + 1) | halfAt(field, at + 2) << 4);
            add(number < kFirstLongSuiteNumber ? std::uint8_t(0) : number);
            at += 2;
        } else {
            break;
        }
    }
    return numbers;
}

} // namespace skyseal::channel
