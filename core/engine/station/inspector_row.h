// The part of a snapshot that the inspector shows.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace skyseal::engine {

/// One row of the inspector: a kind of message of one sender. Filled only while an inspector is open.
struct InspectorRow
{
    std::uint32_t messageId = 0;
    std::string name;
    std::uint8_t systemId = 0, componentId = 0;
    std::uint64_t count = 0;
    double rate = 0; ///< a second
    std::uint8_t version = 2;
    bool isSigned = false;
    std::uint8_t payloadSize = 0;
    std::array<std::uint8_t, 255> payload{}; ///< of the newest message, zero-filled
    double age = 0;                          ///< seconds
};

} // namespace skyseal::engine
