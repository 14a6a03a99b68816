// The vertical line under the mouse and the values beside it: a thin layer of its own above a chart, so that moving it does
// not draw the chart anew.
#pragma once

#include <QtCore/QRectF>
#include <QtCore/QStringList>
#include <QtWidgets/QWidget>

namespace skyseal::ui {

class ChartCursor : public QWidget
{
    Q_OBJECT

public:
    explicit ChartCursor(QWidget *chart);

    /// `x` in pixels of the chart; `plot` is where the line may stand.
    void showAt(qreal x, const QRectF &plot, const QStringList &words);
    void clear();
    const QStringList &words() const { return m_words; }

protected:
    void paintEvent(QPaintEvent *) override;

private:
    QRectF box() const;

    qreal m_x = -1;
    QRectF m_plot;
    QStringList m_words;
};

} // namespace skyseal::ui
