// Reading of one value source from a snapshot.
#pragma once

#include "core/vehicle/vehicle_state.h"
#include "ui/text/value_source.h"
#include "ui/view_state.h"

namespace skyseal::ui {

struct ValueReading
{
    double number = vehicle::kUnknown; ///< in the metric unit that is shown
    QString word = {};                 ///< for values that are words; then shown in place of the number
    bool isBad = false;                ///< the word says that something is wrong
    QString note = {};                 ///< a few words that qualify the value
    QString explanation = {};          ///< of the note, a sentence
    double age = vehicle::kUnknown;    ///< seconds; unknown if the source never came

    double staleAfter = kStaleAfterSeconds;

    bool isStale() const { return age > staleAfter; }
    bool isKnown() const { return !word.isEmpty() || std::isfinite(number); }
};

/// Of the selected vehicle. A field is that of the vehicle's autopilot, or, if it does not send the message, that of the
/// component heard last.
ValueReading readValue(const ValueSource &source, const ViewState &view);

} // namespace skyseal::ui
