// The geometry of a chart: which pixel shows which time and value, and where the bars stand beside the plot.
#pragma once

#include "ui/charts/chart.h"

#include <QtCore/QRectF>

#include <cstddef>
#include <optional>

namespace skyseal::ui {

struct ChartPlot
{
    static constexpr int kBarStep = 10, kBarWidth = 7; ///< pixels

    ChartContent content; ///< without runs, which the chart's series hold
    QRectF area;          ///< pixels in which the lines are drawn; the bars stand to the right of it

    double secondsPerPixel() const;
    /// Returns the time in seconds at this pixel, limited to the area.
    double timeAt(qreal x) const;
    qreal xOf(double time) const;
    qreal yOf(double value) const;
    QRectF barAt(std::size_t index) const;
    /// Returns the index of the bar in this pixel column.
    std::optional<std::size_t> barIndexAt(qreal x) const;
};

} // namespace skyseal::ui
