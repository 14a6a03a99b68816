// The form of a dialog, above its buttons: it scrolls where the screen has no room for all of it, so that the buttons stay on
// the screen.
#pragma once

#include "ui/theme/grid.h"

#include <QtCore/QEvent>
#include <QtGui/QScreen>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLayout>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>

#include <algorithm>

namespace skyseal::ui {

class FormScroll : public QScrollArea
{
    Q_OBJECT

public:
    /// `form` needs a layout. `leastWidth` in pixels, for texts that wrap.
    explicit FormScroll(QWidget *form, int leastWidth = 0) : m_leastWidth(leastWidth)
    {
        setWidget(form);
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus); // Tab leads to the fields, which come into sight
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    }

    QSize sizeHint() const override
    {
        const QLayout &layout = *widget()->layout();
        const int width = std::max(layout.totalSizeHint().width(), minimumSizeHint().width());
        return {width, layout.hasHeightForWidth() ? layout.totalHeightForWidth(width) : layout.totalSizeHint().height()};
    }
    QSize minimumSizeHint() const override
    {
        constexpr int kLeastHeight = 20 * kGrid;
        const int form = std::max(widget()->minimumSizeHint().width(), m_leastWidth);
        return {form + verticalScrollBar()->sizeHint().width(), kLeastHeight};
    }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (watched == widget() && event->type() == QEvent::LayoutRequest)
            updateGeometry(); // its least width may have changed: nothing is cut at the side
        return QScrollArea::eventFilter(watched, event);
    }

private:
    const int m_leastWidth;
};

/// Makes a dialog that is about to be shown as large as it wants to be, within the screen of its window.
inline void fitToScreen(QDialog &dialog)
{
    constexpr QSize kFrame(2 * kGrid, 6 * kGrid); // about what a window manager adds
    const QWidget &window = dialog.parentWidget() ? *dialog.parentWidget() : dialog;
    dialog.resize(dialog.sizeHint().boundedTo(window.screen()->availableSize() - kFrame));
}

} // namespace skyseal::ui
