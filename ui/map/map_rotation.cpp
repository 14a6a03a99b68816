#include "ui/map/map_rotation.h"

#include "ui/map/map_viewport.h"

#include <QtGui/QAction>

#include <cmath>

namespace skyseal::ui {

MapRotation::MapRotation(QObject *parent) : QObject(parent), m_action(new QAction(tr("&Rotate the map with the vehicle"), this))
{
    m_action->setObjectName(QStringLiteral("actionRotateMap"));
    m_action->setCheckable(true);
    m_action->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_N);
    connect(m_action, &QAction::toggled, this, [this](bool on) {
        m_begun = false;
        m_target = 0;
        Q_EMIT toggled(on);
    });
}

bool MapRotation::isOn() const
{
    return m_action->isChecked();
}

void MapRotation::showHeading(double heading, double groundSpeed)
{
    if (!isOn() || !std::isfinite(heading))
        return;
    const double step = groundSpeed >= kSlowest ? kStepMoving : kStepStanding;
    if (m_begun && std::abs(MapViewport::turnBetween(m_target, heading)) < step)
        return;
    m_begun = true;
    m_target = heading - 360 * std::floor(heading / 360);
}

} // namespace skyseal::ui

#include "moc_map_rotation.cpp"
