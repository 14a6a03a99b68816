// Texts that name the vehicle where there are several. The number 0 stands for the only one, which needs no name.
#pragma once

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/view_state.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QString>

namespace skyseal::ui {

inline constexpr int kAnyVehicle = 255; ///< the number that needs the most room

/// The selected vehicle if there are several, else 0.
inline int vehicleToName(const ViewState &view)
{
    return view.vehicle && view.vehicles().size() > 1 ? view.vehicle->state.systemId : 0;
}

/// In one line: "Set mode · 2".
inline QString commandOfVehicle(const QString &command, int systemId)
{
    return systemId == 0 ? command : command + QStringLiteral(" · %1").arg(systemId);
}

/// In full, for screen readers: "Set mode, vehicle 2".
inline QString spokenCommand(const QString &command, int systemId)
{
    return systemId == 0 ? command
                         : QCoreApplication::translate("skyseal::ui::VehicleName", "%1, vehicle %2").arg(command).arg(systemId);
}

} // namespace skyseal::ui
