// Paints the fence and the rally points: areas to stay in with a solid line, areas to keep out of with a dashed line and
// hatching, each with its words.
#pragma once

#include "ui/map/fence.h"
#include "ui/map/map_viewport.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QPalette>

class QPainter;

namespace skyseal::ui {

/// Made for one paint event; the references must outlive it.
class FencePainter
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::FencePainter)

public:
    FencePainter(QPainter &painter, const MapViewport &viewport, const QPalette &palette)
        : m_painter(painter), m_viewport(viewport), m_palette(palette)
    {}

    void paint(const FenceContent &content);

private:
    void paintArea(const FenceArea &area);
    void paintReturnPoint(const QPointF &at);
    void paintRallyPoint(const QPointF &at, std::size_t number);

    QPainter &m_painter;
    const MapViewport &m_viewport;
    const QPalette &m_palette;
};

} // namespace skyseal::ui
