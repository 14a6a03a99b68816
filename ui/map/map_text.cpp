#include "ui/map/map_text.h"

#include "ui/theme/grid.h"

#include <QtGui/QPainter>
#include <QtGui/QPalette>

namespace skyseal::ui {

void paintPlate(QPainter &painter, const QRectF &place, const QPalette &palette)
{
    QColor ground = palette.color(QPalette::Base);
    ground.setAlpha(225);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(place, 3, 3);
    painter.setPen(palette.color(QPalette::WindowText));
}

void paintCaption(QPainter &painter, const QRectF &place, const QString &text, const QPalette &palette)
{
    paintPlate(painter, place, palette);
    painter.drawText(place, Qt::AlignCenter, text);
}

void paintLabel(QPainter &painter, const QPointF &middle, const QString &text, const QPalette &palette)
{
    const QFontMetricsF metrics(painter.font());
    QRectF place(0, 0, metrics.horizontalAdvance(text) + kGrid, metrics.height() + 2);
    place.moveCenter(middle);
    paintCaption(painter, place, text, palette);
}

} // namespace skyseal::ui
