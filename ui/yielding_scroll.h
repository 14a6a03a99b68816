// The content of a dock whose panel has lists or charts of its own, and takes their room from the dock. Touch-sized controls
// need more room than small screens have: then the panel scrolls below its least size, so that no panel makes the window larger
// than the screen.
#pragma once

#include "ui/theme/grid.h"
#include "ui/theme/instrument_style.h"

#include <QtCore/QEvent>
#include <QtWidgets/QScrollArea>

namespace skyseal::ui {

class YieldingScroll : public QScrollArea
{
    Q_OBJECT

public:
    explicit YieldingScroll(QWidget *panel)
    {
        setWidget(panel);
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);
        setFocusProxy(panel); // what has no focus of its own must not take it from the panel
    }

    QSize sizeHint() const override { return widget()->sizeHint(); }
    QSize minimumSizeHint() const override
    {
        constexpr QSize kLeast(38 * kGrid, 14 * kGrid);
        const QSize wanted = widget()->minimumSizeHint().expandedTo(widget()->minimumSize());
        return leastTarget(*this) == 0 ? wanted : wanted.boundedTo(kLeast);
    }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (watched == widget() && event->type() == QEvent::LayoutRequest)
            updateGeometry(); // its least size may have changed
        return QScrollArea::eventFilter(watched, event);
    }
};

} // namespace skyseal::ui
