// Input of an altitude above home in the operator's unit; the value is in metres.
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
    /// Instead of kHighestTakeOff, metres.
    void setHighest(double metres);
    /// Limited to kLowestTakeOff … the highest.
    void setMetres(double metres);

Q_SIGNALS:
    /// Emitted only for changes by the operator.
    void metresChanged(double metres);

private:
    void show();

    UnitSystem m_units = UnitSystem::Metric;
    double m_metres = 10, m_highest = kHighestTakeOff;
};

} // namespace skyseal::ui
