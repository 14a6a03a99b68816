// Paints a measurement on the map: its points, the length and bearing of each leg, and the total.
#pragma once

#include "ui/map/map_viewport.h"
#include "ui/map/measure_tool.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QPalette>

class QPainter;

namespace skyseal::ui {

/// Made for one paint event; the references must outlive it.
class MeasurePainter
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::MeasurePainter)

public:
    MeasurePainter(QPainter &painter, const MapViewport &viewport, const QPalette &palette)
        : m_painter(painter), m_viewport(viewport), m_palette(palette)
    {}

    /// `pointed`: where the next point would be set; the way to it is dashed.
    void paint(const MeasureTool &tool, const std::optional<LatLong> &pointed, UnitSystem units);

private:
    QPolygonF pixelsOf(const std::vector<LatLong> &places) const;
    void paintLine(const QPolygonF &line, Qt::PenStyle style);
    void paintLeg(const QPointF &from, const QPointF &to, const QString &text, bool always);
    void paintPoint(const QPointF &at);
    void paintCross(const QPointF &at);
    void paintNextLeg(const QPointF &cross, const QString &text);
    void paintTotal(const QString &total);
    QRectF captionFor(const QString &text) const; ///< its size
    void paintFreeCaption(const QRectF &place, const QString &text);

    QPainter &m_painter;
    const MapViewport &m_viewport;
    const QPalette &m_palette;
    std::vector<QRectF> m_taken; ///< by captions of legs
};

} // namespace skyseal::ui
