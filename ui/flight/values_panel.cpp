#include "ui/flight/values_panel.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QGridLayout>

namespace skyseal::ui {

ValuesPanel::ValuesPanel(QWidget *parent) : QWidget(parent)
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(kGrid, kHalfGrid, kGrid, kHalfGrid);
    grid->setHorizontalSpacing(kHalfGrid);
    grid->setVerticalSpacing(2);
    const QString figure = QStringLiteral("-888.8");
    m_altitude = addRow(grid, 0, 0, tr("alt"), QStringLiteral("valueAltitude"), figure, QStringLiteral("m/s"));
    m_speed = addRow(grid, 1, 0, tr("speed"), QStringLiteral("valueSpeed"), figure, QStringLiteral("m/s"));
    m_climb = addRow(grid, 2, 0, tr("climb"), QStringLiteral("valueClimb"), figure, QStringLiteral("m/s"));
    m_current = addRow(grid, 3, 0, tr("current"), QStringLiteral("valueCurrent"), figure, QStringLiteral("m/s"));
    m_ekf = addRow(grid, 4, 0, tr("EKF"), QStringLiteral("valueEkf"), figure, QStringLiteral("m/s"));
    m_heading = addRow(grid, 0, 3, tr("hdg"), QStringLiteral("valueHeading"), figure, QStringLiteral("km"));
    m_home = addRow(grid, 1, 3, tr("home"), QStringLiteral("valueHome"), figure, QStringLiteral("km"));
    m_time = addRow(grid, 2, 3, tr("time"), QStringLiteral("valueTime"), figure, QStringLiteral("km"));
    m_hdop = addRow(grid, 3, 3, tr("HDOP"), QStringLiteral("valueHdop"), figure, QStringLiteral("km"));
    m_throttle = addRow(grid, 4, 3, tr("throttle"), QStringLiteral("valueThrottle"), figure, QStringLiteral("km"));
    grid->setColumnStretch(1, 1);
    grid->setColumnMinimumWidth(2, kGrid);
    grid->setColumnStretch(4, 1);

    m_age = new QLabel(this);
    m_age->setObjectName(QStringLiteral("valueAge"));
    m_age->setAccessibleName(tr("Age of the values"));
    QSizePolicy keepsRoom = m_age->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_age->setSizePolicy(keepsRoom);
    m_age->setForegroundRole(QPalette::PlaceholderText);
    grid->addWidget(m_age, 5, 0, 1, 5);
    showViewState({});
}

FigureLabel *ValuesPanel::addRow(QGridLayout *grid, int row, int column, const QString &name, const QString &objectName,
                                 const QString &sample, const QString &sampleUnit)
{
    auto *label = new QLabel(name, this);
    label->setForegroundRole(QPalette::PlaceholderText);
    auto *value = new FigureLabel(this);
    value->setObjectName(objectName);
    value->setAccessibleName(name);
    value->setSample(sample, sampleUnit);
    label->setBuddy(value);
    grid->addWidget(label, row, column);
    grid->addWidget(value, row, column + 1);
    return value;
}

void ValuesPanel::showViewState(const ViewState &view)
{
    static const vehicle::VehicleState kNothing;
    const auto &state = view.vehicle ? view.vehicle->state : kNothing;
    const auto put = [](FigureLabel *label, const Figure &figure) { label->setFigure(figure.value, figure.unit); };
    put(m_altitude, altitudeFigure(state.altitudeRelative, m_units));
    put(m_speed, speedFigure(state.groundSpeed, m_units));
    put(m_climb, climbFigure(state.climb, m_units));
    put(m_current, {number(state.batteryCurrent, 1), QStringLiteral("A")});
    put(m_heading, headingFigure(state.heading));
    put(m_home, distanceFigure(state.distanceHome, m_units));
    put(m_time, {view.vehicle ? durationText(state.flightTime) : dash(), {}});
    put(m_hdop, {number(state.hdop, 1), {}});
    put(m_throttle, {number(state.throttle, 0), QStringLiteral("%")});
    put(m_ekf, {!state.ekfOk ? dash() : *state.ekfOk ? tr("good") : tr("bad"), {}});
    m_ekf->setColor(state.ekfOk && !*state.ekfOk ? stateColors(palette()).alarm : QColor());
    const bool stale = view.stale();
    for (FigureLabel *label : {m_altitude, m_speed, m_climb, m_current, m_ekf, m_heading, m_home, m_time, m_hdop, m_throttle})
        label->setStale(stale);
    const QString age = stale ? tr("Last heard %1 ago").arg(durationText(state.messageAge)) : QString();
    if (m_age->text() != age)
        m_age->setText(age);
}

} // namespace skyseal::ui
