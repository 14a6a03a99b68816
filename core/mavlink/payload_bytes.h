// Reads and writes the fields of the generated messages: little-endian at fixed offsets.
#pragma once

#include "core/base/bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace skyseal::mavlink {

static_assert(std::endian::native == std::endian::little, "the fields are copied as they lie on the wire");

/// The first N bytes of a payload, zeros where it is shorter (MAVLink 2 trims trailing zeros).
template<std::size_t N> class PayloadBytes
{
public:
    explicit PayloadBytes(ByteView payload)
    {
        const std::size_t size = std::min(N, payload.size());
        std::copy_n(payload.data(), size, m_raw.data()); // an empty payload may have no address
        // Not memset(), which _FORTIFY_SOURCE=3 replaces by a call that takes as long as all the rest of decoding.
        std::fill(m_raw.begin() + size, m_raw.end(), std::uint8_t(0));
    }

    template<typename T> void load(std::size_t offset, T &field) const
    {
        std::memcpy(&field, m_raw.data() + offset, sizeof(T));
    }

private:
    std::array<std::uint8_t, N> m_raw;
};

template<typename T> void storeField(std::uint8_t *out, const T &field)
{
    std::memcpy(out, &field, sizeof(T));
}

/// The text of a char array: up to its first NUL, or all of it when there is none.
template<std::size_t N> std::string_view textOf(const std::array<char, N> &field)
{
    return {field.data(), static_cast<std::size_t>(std::find(field.begin(), field.end(), '\0') - field.begin())};
}

/// The values by which a field of a generated message says "not known", for each of its elements: a specialisation for every
/// field that has some, from its `invalid` attribute in the definitions and from resources/dialects/unknown_values.txt.
template<auto Field> inline constexpr std::array<std::uint8_t, 0> kNotKnown{};

/// False for NaN and for the values of kNotKnown. `value` is the field, or one element of it.
template<auto Field, typename Value> constexpr bool isKnown(Value value)
{
    if constexpr (std::is_floating_point_v<Value>) {
        if (std::isnan(value))
            return false;
    }
    for (const auto unknown : kNotKnown<Field>) {
        if (value == unknown)
            return false;
    }
    return true;
}

/// Copies a text into a char array, cut to its length, the rest zero.
template<std::size_t N> void setText(std::array<char, N> &field, std::string_view text)
{
    field.fill('\0');
    std::copy_n(text.begin(), std::min(N, text.size()), field.begin());
}

} // namespace skyseal::mavlink
