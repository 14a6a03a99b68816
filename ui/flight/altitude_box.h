// Asks for a height in the operator's unit and gives it in metres.
#pragma once

#include "ui/settings.h"
#include "ui/text/units.h"

#include <QtWidgets/QDoubleSpinBox>

namespace skyseal::ui {

class AltitudeBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit AltitudeBox(QWidget *parent = nullptr);

    void setUnits(UnitSystem units);
    double metres() const { return m_metres; }
    /// Held to the limits of a take-off.
    void setMetres(double metres);

Q_SIGNALS:
    /// By the operator's hand alone.
    void metresChanged(double metres);

private:
    void show();

    UnitSystem m_units = UnitSystem::Metric;
    double m_metres = 10;
};

} // namespace skyseal::ui
