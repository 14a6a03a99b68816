#include "ui/values/value_reading.h"

#include "core/engine/station/snapshot.h"
#include "ui/text/vehicle_text.h"
#include "ui/view_state.h"

#include <QtCore/QCoreApplication>

#include <cmath>

namespace skyseal::ui {

namespace {

struct ValueReadingText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ValueReading)
};

ValueReading readState(const ValueSource &source, const vehicle::VehicleState &state)
{
    ValueReading out;
    out.age = state.messageAge;
    out.staleAfter = state.staleAfter;
    const vehicle::StateField &field = *source.state;
    if (field.text) {
        out.word = fromStd(field.text(state));
        return out;
    }
    const double number = field.number(state);
    if (source.isNumber()) {
        out.number = number * source.unit().factor;
        if (field.name == "flight_time" && !state.takeOffSeen) {
            out.note = ValueReadingText::tr("since first heard");
            out.explanation = ValueReadingText::tr(
                "The vehicle was already flying when this station first heard it. The time counts from "
                "then: the flight itself is longer.");
        }
    } else if (!std::isfinite(number)) {
        return out;
    } else if (field.name == "gps_fix") {
        out.word = fixText(static_cast<int>(number));
    } else if (field.name == "ekf_ok") {
        out.isBad = number == 0;
        out.word = out.isBad ? ValueReadingText::tr("bad") : ValueReadingText::tr("good");
    } else {
        out.word = number != 0 ? ValueReadingText::tr("yes") : ValueReadingText::tr("no");
    }
    return out;
}

const engine::FieldReading *newest(const engine::FieldChoice &choice, const ViewState &view)
{
    const vehicle::VehicleState &state = view.vehicle->state;
    const engine::FieldReading *best = nullptr;
    for (const engine::FieldReading &reading : view.snapshot->fields) {
        if (reading.choice != choice || reading.systemId != state.systemId)
            continue;
        if (reading.componentId == state.componentId)
            return &reading;
        if (!best || reading.age < best->age)
            best = &reading;
    }
    return best;
}

} // namespace

ValueReading readValue(const ValueSource &source, const ViewState &view)
{
    if (!view.vehicle)
        return {};
    if (source.state)
        return readState(source, view.vehicle->state);
    const engine::FieldReading *reading = newest(*source.fieldChoice(), view);
    if (!reading)
        return {};
    ValueReading out;
    out.age = reading->age;
    if (!isKnown(reading->value, source.field->unknown))
        return out;
    if (!source.isNumber())
        out.word = enumEntryText(*source.field, reading->value);
    if (out.word.isEmpty())
        out.number = reading->value.asDouble() * source.unit().factor;
    return out;
}

} // namespace skyseal::ui
