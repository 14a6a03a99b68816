// Aircraft in the neighbourhood of the selected vehicle, as the map draws them.
#pragma once

#include "ui/text/aircraft_text.h"
#include "ui/view_state.h"

#include <QtCore/QPointF>

#include <vector>

namespace skyseal::ui {

struct AircraftMark
{
    QPointF at;         ///< metres of the projection, see mercator.h
    double heading = 0; ///< degrees; NaN if unknown
    AircraftSight sight;
};

class TrafficContent
{
public:
    /// Returns true if anything changed.
    bool show(const ViewState &view);
    const std::vector<AircraftMark> &marks() const { return m_marks; }

private:
    std::vector<AircraftMark> m_marks;
};

} // namespace skyseal::ui
