// A dock's content that scrolls up and down where nothing else helps. It tells how much height there is, so that a panel can
// leave out what matters least before the operator has to scroll.
#pragma once

#include "ui/theme/grid.h"

#include <QtWidgets/QScrollArea>

namespace skyseal::ui {

class FittingScroll : public QScrollArea
{
    Q_OBJECT

public:
    explicit FittingScroll(QWidget *panel)
    {
        setWidget(panel);
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setMinimumWidth(panel->minimumSizeHint().width() + 2 * kGrid);
    }

Q_SIGNALS:
    void heightChanged(int height);

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        Q_EMIT heightChanged(height() - 2 * frameWidth());
        QScrollArea::resizeEvent(event);
    }
};

} // namespace skyseal::ui
