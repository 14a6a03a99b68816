// Asks for an altitude and sends a command with it by a hold button, like the action bar. It applies to the vehicle that was
// selected when it opened.
#pragma once

#include "core/vehicle/vehicle_command.h"
#include "ui/settings.h"
#include "ui/text/units.h"

#include <QtWidgets/QDialog>

#include <cstdint>
#include <optional>

namespace skyseal::ui {

class AltitudeBox;
class VehicleCommands;

class AltitudeDialog : public QDialog
{
    Q_OBJECT

protected:
    /// Metres: above what any flight may have reached, so that nothing descends by mistake.
    static constexpr double kHighestFlown = 10'000;

    struct Wording
    {
        QString id;                       ///< object name; "Altitude" and "Go" are appended for the parts
        QString title;                    ///< without the vehicle
        QString hint;                     ///< what will happen
        QString verb;                     ///< text of the hold button
        double highest = kHighestTakeOff; ///< metres above home
        /// Reasons against it disable the button, which else is disabled only if nothing can be sent.
        std::optional<vehicle::VehicleCommand> permit = {};
        /// In their place while `permit` arms the vehicle on its way.
        QString armingHint = {}, armingVerb = {};
    };

    /// `metres`: the altitude that is offered.
    AltitudeDialog(VehicleCommands &commands, UnitSystem units, double metres, const Wording &wording, QWidget *parent);

    /// The operator has confirmed.
    virtual void command(VehicleCommands &commands, std::uint8_t systemId, double metres) = 0;
};

} // namespace skyseal::ui
