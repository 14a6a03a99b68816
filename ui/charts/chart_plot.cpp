#include "ui/charts/chart_plot.h"

#include "ui/theme/grid.h"

#include <algorithm>

namespace skyseal::ui {

double ChartPlot::secondsPerPixel() const
{
    return (content.to - content.from) / std::max(1.0, area.width());
}

double ChartPlot::timeAt(qreal x) const
{
    return content.from + (std::clamp(x, area.left(), area.right()) - area.left()) * secondsPerPixel();
}

qreal ChartPlot::xOf(double time) const
{
    return area.left() + (time - content.from) / secondsPerPixel();
}

qreal ChartPlot::yOf(double value) const
{
    return area.bottom() - std::clamp(value / content.top, 0.0, 1.0) * area.height();
}

QRectF ChartPlot::barAt(std::size_t index) const
{
    const qreal top = yOf(content.bars[index].mean);
    return {area.right() + kGrid + static_cast<qreal>(index) * kBarStep, top, kBarWidth, area.bottom() - top};
}

std::optional<std::size_t> ChartPlot::barIndexAt(qreal x) const
{
    for (std::size_t i = 0; i < content.bars.size(); ++i) {
        const qreal left = barAt(i).left();
        if (x >= left - 1 && x < left + kBarStep - 1)
            return i;
    }
    return std::nullopt;
}

} // namespace skyseal::ui
