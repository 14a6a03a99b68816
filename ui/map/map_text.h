// Text that can be read on any ground of the map: on a rounded plate through which the map shows a little.
#pragma once

#include <QtCore/QPointF>
#include <QtCore/QString>

class QPainter;
class QPalette;
class QRectF;

namespace skyseal::ui {

/// The plate alone; leaves the painter with the pen for text.
void paintPlate(QPainter &painter, const QRectF &place, const QPalette &palette);
/// `text` in the middle of the plate.
void paintCaption(QPainter &painter, const QRectF &place, const QString &text, const QPalette &palette);
/// A caption as large as its text around `middle`.
void paintLabel(QPainter &painter, const QPointF &middle, const QString &text, const QPalette &palette);

} // namespace skyseal::ui
