// Numbers that keep still: every digit takes the same width whatever the font's figures look like, so that a changing
// value moves nothing beside it.
#pragma once

#include <QtGui/QFontMetricsF>
#include <QtWidgets/QLabel>

class QPainter;

namespace skyseal::ui {

/// Width of `text` with every digit as wide as the font's widest.
qreal figuresWidth(const QFontMetricsF &metrics, const QString &text);

/// Draws `text` with its left end and baseline at `at`.
void drawFigures(QPainter &painter, const QPointF &at, const QString &text);

/// A value, right-aligned, with its unit dimmed behind it. A stale value is grey. Sized for its widest content, given as
/// a sample, so that it never asks for another width.
class FigureLabel : public QLabel
{
    Q_OBJECT

public:
    explicit FigureLabel(QWidget *parent = nullptr);

    /// The widest content to make room for.
    void setSample(const QString &value, const QString &unit);
    /// Repaints only when something changed.
    void setFigure(const QString &value, const QString &unit = {});
    void setStale(bool stale);
    /// A colour for the value; invalid = the palette's.
    void setColor(const QColor &color);

    QString value() const { return m_value; }
    QString unit() const { return m_unit; }
    bool isStale() const { return m_stale; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *) override;

private:
    qreal widthOf(const QString &value, const QString &unit) const;

    QString m_value, m_unit, m_sampleValue, m_sampleUnit;
    QColor m_color;
    bool m_stale = false;
};

} // namespace skyseal::ui
