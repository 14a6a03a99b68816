// The content of a side dock: scrolls vertically if needed, and reports the available height, so that a panel can hide less
// important parts before the operator has to scroll.
#pragma once

#include "ui/theme/grid.h"

#include <QtWidgets/QScrollArea>

#include <algorithm>

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
        setFocusPolicy(Qt::NoFocus); // Tab would stop where nothing is to be seen; keys that its controls leave scroll it
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setMinimumWidth(std::max(panel->minimumWidth(), panel->minimumSizeHint().width()) + 2 * kGrid);
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
