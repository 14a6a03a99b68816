// The time line of a recording: where the replay is, where the vehicles were armed and changed their modes, where the links
// changed their cipher, and where nothing was recorded. A slider in milliseconds: arrows move by 1 s, Page keys by 10 s, Home
// and End to the ends, Ctrl with an arrow to the next mark; a press of the mouse goes to the place under it.
#pragma once

#include "core/log/log_index.h"

#include <QtGui/QColor>
#include <QtWidgets/QAbstractSlider>

#include <memory>
#include <vector>

namespace skyseal::ui {

class ReplayTimeline : public QAbstractSlider
{
    Q_OBJECT

public:
    explicit ReplayTimeline(QWidget *parent = nullptr);

    /// Null until the recording was read: the line cannot be used before.
    void setIndex(std::shared_ptr<const tlog::LogIndex> index);
    /// The position of the replay. Ignored while the operator drags.
    void showPosition(Duration position);
    /// As if the operator had chosen the place, in milliseconds.
    void seekTo(int place);
    /// As above, to the next mark after or before the position, or to an end.
    void goToMark(bool forward);

    /// Places of the gaps, mode changes, times armed and cipher switches in words, for the tool tip at a pixel and for screen
    /// readers; empty where there is none.
    QString textAt(int x) const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    /// The operator chose another position.
    void seekRequested(skyseal::Duration to);

protected:
    void paintEvent(QPaintEvent *) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    bool event(QEvent *event) override;

private:
    struct Mark
    {
        Duration from{}, to{};
        QString text; ///< with its time
        enum class Kind { Mode, Armed, Gap, Suite } kind{};
        QColor color{}; ///< of a suite
    };

    void collectMarks();
    void collectSuites();
    void describeMarks();
    void paintMark(QPainter &painter, const Mark &mark) const;
    qreal pixelOf(Duration at) const;
    int millisecondsAt(int x) const;
    QRectF lineRect() const;

    std::shared_ptr<const tlog::LogIndex> m_index;
    std::vector<Mark> m_marks; ///< by their beginning
};

} // namespace skyseal::ui
