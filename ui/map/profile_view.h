// Draws the altitude profile of a mission: a line over the way, with the numbers of its items. Lives on the GUI thread.
#pragma once

#include "ui/map/altitude_profile.h"
#include "ui/text/units.h"

#include <QtWidgets/QWidget>

namespace skyseal::ui {

class ProfileView : public QWidget
{
    Q_OBJECT

public:
    explicit ProfileView(QWidget *parent = nullptr);

    /// `current` is the item that the vehicle flies to, -1 if none is known.
    void showProfile(std::vector<ProfilePoint> points, int current);
    void setUnits(UnitSystem units);
    /// "1 240 m · highest 48.0 m above home".
    QString summary() const;

    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *) override;
    void changeEvent(QEvent *event) override;

private:
    /// Metres of the profile that the widget shows.
    struct Range
    {
        double length, lowest, highest;
    };
    Range range() const;
    void paintGrid(QPainter &painter, const QRectF &area, const Range &range);
    void paintLine(QPainter &painter, const std::vector<QPointF> &places);
    void paintPoints(QPainter &painter, const std::vector<QPointF> &places);

    std::vector<ProfilePoint> m_points;
    int m_current = -1;
    UnitSystem m_units = UnitSystem::Metric;
};

} // namespace skyseal::ui
