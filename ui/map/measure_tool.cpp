#include "ui/map/measure_tool.h"

#include <QtGui/QAction>
#include <QtGui/QKeyEvent>

namespace skyseal::ui {

MeasureTool::MeasureTool(QObject *parent) : QObject(parent), m_action(new QAction(tr("M&easure on the map"), this))
{
    m_action->setObjectName(QStringLiteral("actionMeasure"));
    m_action->setCheckable(true);
    m_action->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_M);
    connect(m_action, &QAction::toggled, this, [this] {
        m_points.clear();
        m_legs.clear();
        Q_EMIT changed();
    });
}

bool MeasureTool::isOn() const
{
    return m_action->isChecked();
}

void MeasureTool::end()
{
    m_action->setChecked(false);
}

void MeasureTool::add(const LatLong &place)
{
    if (!m_points.empty())
        m_legs.push_back(geodesicBetween(m_points.back(), place));
    m_points.push_back(place);
    Q_EMIT changed();
}

void MeasureTool::removeLast()
{
    if (m_points.empty())
        return;
    m_points.pop_back();
    if (!m_legs.empty())
        m_legs.pop_back();
    Q_EMIT changed();
}

bool MeasureTool::handleKey(const QKeyEvent &event, const std::optional<LatLong> &pointed)
{
    if (!isOn())
        return false;
    switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
        if (pointed && !event.isAutoRepeat())
            add(*pointed);
        return true;
    case Qt::Key_Backspace: removeLast(); return true;
    case Qt::Key_Escape: end(); return true;
    default: return false;
    }
}

double MeasureTool::totalMetres() const
{
    double metres = 0;
    for (const Geodesic &leg : m_legs)
        metres += leg.metres;
    return metres;
}

QString legText(const Geodesic &leg, UnitSystem units)
{
    return QStringLiteral("%1 · %2°").arg(distanceFigure(leg.metres, units).text(), headingFigure(leg.bearing).value);
}

QString measuredText(const MeasureTool &tool, UnitSystem units)
{
    const auto legs = tool.legs().size();
    if (legs == 0)
        return tool.points().empty() ? MeasureTool::tr("Measure: set the first point")
                                     : MeasureTool::tr("Measure: set the next point");
    const QString total = distanceFigure(tool.totalMetres(), units).text();
    return legs == 1 ? MeasureTool::tr("%1 in one leg").arg(total) : MeasureTool::tr("%1 in %2 legs").arg(total).arg(legs);
}

} // namespace skyseal::ui

#include "moc_measure_tool.cpp"
