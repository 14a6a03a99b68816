// Where a value in the grid comes from: a quantity that the station derives for a vehicle, or a field of a message. Sources are
// stored and shown by their names: "alt_rel", "ATTITUDE.roll", "BATTERY_STATUS.voltages[3]".
#pragma once

#include "core/engine/station/field_reading.h"
#include "core/mavlink/dialect.h"
#include "core/vehicle/state_fields.h"
#include "ui/text/value_unit.h"

#include <optional>
#include <span>
#include <vector>

namespace skyseal::ui {

/// Either `state` is set, or `message` and `field` are; all point into constant tables.
struct ValueSource
{
    const vehicle::StateField *state = nullptr;
    const mavlink::MessageInfo *message = nullptr;
    const mavlink::FieldInfo *field = nullptr;
    std::uint8_t element = 0; ///< of an array

    /// The name that is stored; findValueSource() reads it.
    QString id() const;
    /// "Altitude above home", "BATTERY_STATUS.voltages[3]".
    QString title() const;
    /// Short, for the grid: "alt", "voltages[3]".
    QString caption() const;
    /// Type, enumeration and meaning, for people.
    QString description() const;
    /// As the definition names it, empty for none: "cdeg".
    QString sourceUnit() const;
    ValueUnit unit() const;
    /// True for a number whose definition names no unit: the operator may name one.
    bool takesUnit() const;
    /// False for words, which have neither decimals, limits nor a line.
    bool isNumber() const;
    std::size_t elements() const { return field ? field->elements() : 1; }
    /// Empty for a derived quantity.
    std::optional<engine::FieldChoice> fieldChoice() const;
};

/// Nullopt if there is no such quantity, message, field or element, or the field is text.
std::optional<ValueSource> findValueSource(const QString &id);

/// All sources, the derived ones first; an array appears once, with its first element.
std::span<const ValueSource> valueSources();

/// The entry of the field's enumeration without what all its entries begin with ("3D FIX"); empty if there is none.
QString enumEntryText(const mavlink::FieldInfo &field, mavlink::FieldValue value);

} // namespace skyseal::ui
