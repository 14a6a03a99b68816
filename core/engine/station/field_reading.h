// The part of a snapshot that shows single fields of messages: those that the operator has chosen, and no others.
#pragma once

#include "core/mavlink/field_value.h"

namespace skyseal::engine {

/// One field of a message of any dialect that has it, and the element of an array (0 for a single value).
struct FieldChoice
{
    std::uint32_t messageId = 0;
    const mavlink::FieldInfo *field = nullptr; ///< of the built-in dialect; never null in a choice that is made
    std::uint8_t element = 0;                  ///< below field->elements()

    bool operator==(const FieldChoice &) const = default;
};

/// The newest value of a chosen field from one sender.
struct FieldReading
{
    FieldChoice choice;
    std::uint8_t systemId = 0, componentId = 0;
    mavlink::FieldValue value;
    double age = 0; ///< seconds
};

} // namespace skyseal::engine
