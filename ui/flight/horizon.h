// The artificial horizon: attitude in the middle, speed on the left, altitude on the right, compass below. Repaints only
// when a visible value has changed.
#pragma once

#include "ui/flight/horizon_values.h"
#include "ui/text/units.h"

#include <QtWidgets/QWidget>

namespace skyseal::ui {

class Horizon : public QWidget
{
    Q_OBJECT

public:
    explicit Horizon(QWidget *parent = nullptr);

    void showValues(const HorizonValues &values);
    void setUnits(UnitSystem units);

    QSize sizeHint() const override { return {272, 224}; }
    QSize minimumSizeHint() const override { return {216, 136}; }

protected:
    void paintEvent(QPaintEvent *) override;

private:
    void paintWorld(QPainter &painter, const QRectF &area) const;
    void paintLadder(QPainter &painter, double pixelsPerDegree, double reach) const;
    void paintRollScale(QPainter &painter, const QRectF &area) const;
    void paintAircraft(QPainter &painter, const QRectF &area) const;
    void paintNumbers(QPainter &painter, const QRectF &area) const;

    HorizonValues m_values;
    UnitSystem m_units = UnitSystem::Metric;
};

} // namespace skyseal::ui
