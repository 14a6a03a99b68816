// One vehicle in the list of all vehicles: what each column says of it. Values, no widgets.
#pragma once

#include "ui/alerts/alert.h"
#include "ui/view_state.h"

#include <QtCore/QString>

#include <array>
#include <span>

namespace skyseal::ui {

enum class CellTone : std::uint8_t { Usual, Dim, Warning, Alarm };

struct VehicleListCell
{
    QString text = {};
    CellTone tone = CellTone::Usual;
    QString tip = {};  ///< a sentence or more
    QString icon = {}; ///< empty: none
    double rank = 0;   ///< by which the column is sorted, as coarse as the text; where equal, by the text

    /// Whether the two look the same, apart from the tip, which is read when it is shown.
    bool looksAs(const VehicleListCell &other) const { return text == other.text && tone == other.tone && icon == other.icon; }
};

struct VehicleListRow
{
    enum Column { Vehicle, Kind, Mode, Armed, Battery, Link, LastFrame, Lock, Alerts, Columns };

    std::uint8_t systemId = 0;
    bool selected = false; ///< it is the one that the window shows
    std::array<VehicleListCell, Columns> cells;

    VehicleListCell &operator[](Column column) { return cells[column]; }
    const VehicleListCell &operator[](Column column) const { return cells[column]; }
};

/// The row of the vehicle that `view` is of, which must have one. `alerts` are those of all vehicles.
VehicleListRow vehicleListRowOf(const ViewState &view, std::span<const Alert> alerts);

} // namespace skyseal::ui
