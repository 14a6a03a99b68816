// The vertical line under the mouse and the values beside it: a thin layer of its own above a chart, so that moving it does
// not draw the chart anew.
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

    /// `x` in pixels of the chart; `plot` is where the line may stand, `curves` the points that are best not covered.
    void showAt(qreal x, const QRectF &plot, const QStringList &words, const std::vector<QPointF> &curves);
    void clear();
    const QStringList &words() const { return m_words; }
    /// Where the words stand.
    const QRectF &box() const { return m_box; }

protected:
    void paintEvent(QPaintEvent *) override;

private:
    QSizeF wordsSize() const;
    void placeBox(const std::vector<QPointF> &curves);

    qreal m_x = -1;
    QRectF m_plot, m_box;
    QStringList m_words;
    std::size_t m_place = 0; ///< of those that placeBox() weighs
};

} // namespace skyseal::ui
