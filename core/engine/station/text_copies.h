// A vehicle with several links sends each STATUSTEXT over all of them. Finds the copies, so that the operator reads a text
// once. A text that the vehicle repeats comes again over the same link, and is no copy. No I/O and no clock; does not allocate.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/mavlink/frame.h"

#include <array>
#include <cstdint>

namespace skyseal::engine {

class TextCopies
{
public:
    /// The greatest difference of the delays of two links.
    static constexpr Duration kWithin = std::chrono::seconds(5);

    /// Takes a STATUSTEXT in clear. Returns true if the same text, or the same part of one, arrived from another link or
    /// address.
    bool isCopy(TimePoint now, const Path &from, const mavlink::Frame &text);

private:
    static constexpr std::size_t kTexts = 32;
    static constexpr std::size_t kPaths = 4; ///< over which one text is expected
    static constexpr std::size_t kLongest = 54;

    struct Text
    {
        TimePoint at = TimePoint::min();
        std::uint8_t system = 0, component = 0;
        std::size_t size = 0;
        std::array<std::uint8_t, kLongest> payload{};
        std::size_t paths = 0;
        std::array<Path, kPaths> heardFrom{};
    };

    std::array<Text, kTexts> m_texts;
    std::size_t m_next = 0; ///< the oldest
};

} // namespace skyseal::engine
