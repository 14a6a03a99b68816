// The vertical line under the mouse and the values beside it: a layer above the chart, so that moving it does not redraw the
// chart.
#pragma once

#include <QtCore/QRectF>
#include <QtCore/QStringList>
#include <QtWidgets/QWidget>

#include <vector>

namespace skyseal::ui {

class ChartCursor : public QWidget
{
    Q_OBJECT

public:
    explicit ChartCursor(QWidget *chart);

    /// All coordinates are pixels of the chart: the line at `x` within `plot`; the box avoids the points in `curves`.
    void showAt(qreal x, const QRectF &plot, const QStringList &lines, const std::vector<QPointF> &curves);
    void clear();
    const QStringList &lines() const { return m_lines; }
    /// The rectangle of the text.
    const QRectF &box() const { return m_box; }

protected:
    void paintEvent(QPaintEvent *) override;

private:
    QSizeF textSize() const;
    void placeBox(const std::vector<QPointF> &curves);

    qreal m_x = -1;
    QRectF m_plot, m_box;
    QStringList m_lines;
    std::size_t m_place = 0; ///< index among the places that placeBox() compares
};

} // namespace skyseal::ui
