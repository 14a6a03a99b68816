#include "ui/flight/altitude_box.h"

#include <QtCore/QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

double metresPerUnit(UnitSystem units)
{
    return 1 / altitudeScale(units).factor;
}

} // namespace

AltitudeBox::AltitudeBox(QWidget *parent) : QDoubleSpinBox(parent)
{
    setAccessibleName(tr("Take-off altitude"));
    setDecimals(0);
    show();
    connect(this, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        m_metres = std::clamp(value * metresPerUnit(m_units), kLowestTakeOff, m_highest);
        Q_EMIT metresChanged(m_metres);
    });
}

void AltitudeBox::setUnits(UnitSystem units)
{
    m_units = units;
    show();
}

void AltitudeBox::setHighest(double metres)
{
    m_highest = metres;
    show();
}

void AltitudeBox::setMetres(double metres)
{
    m_metres = std::clamp(metres, kLowestTakeOff, m_highest);
    show();
}

void AltitudeBox::show()
{
    const QSignalBlocker quiet(this);
    const double unit = metresPerUnit(m_units);
    setSuffix(QLatin1Char(' ') + QLatin1String(altitudeScale(m_units).name));
    setRange(std::ceil(kLowestTakeOff / unit), std::floor(m_highest / unit));
    setSingleStep(m_units == UnitSystem::Metric ? 1 : 5);
    setValue(m_metres / unit);
    setToolTip(tr("Above home, %1 to %2%3").arg(minimum()).arg(maximum()).arg(suffix()));
}

} // namespace skyseal::ui

#include "moc_altitude_box.cpp"
