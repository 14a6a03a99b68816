// The content of a dock whose panel has lists or charts of its own, and takes their room from the dock. Touch-sized controls
// need more room than small screens have: then the panel scrolls below its least size, so that no panel makes the window larger
// than the screen.
#pragma once

#include "ui/theme/grid.h"
#include "ui/theme/instrument_style.h"

#include <QtCore/QEvent>
#include <QtWidgets/QScrollArea>

namespace skyseal::ui {

/// Gives a panel all of its room. A scroll area would otherwise give a panel with wrapped texts the height that it prefers,
/// and scroll where its least height has room.
class PanelRoom : public QWidget
{
    Q_OBJECT

public:
    explicit PanelRoom(QWidget *panel) : m_panel(panel) { panel->setParent(this); }

    QSize sizeHint() const override { return m_panel->sizeHint(); }
    QSize minimumSizeHint() const override { return m_panel->minimumSizeHint().expandedTo(m_panel->minimumSize()); }

protected:
    void resizeEvent(QResizeEvent *) override { m_panel->resize(size()); }
    bool event(QEvent *event) override
    {
        if (event->type() == QEvent::LayoutRequest)
            updateGeometry(); // the panel's least size may have changed
        return QWidget::event(event);
    }

private:
    QWidget *m_panel;
};

class YieldingScroll : public QScrollArea
{
    Q_OBJECT

public:
    explicit YieldingScroll(QWidget *panel)
    {
        setWidget(new PanelRoom(panel));
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);
        setFocusProxy(panel); // what has no focus of its own must not take it from the panel
    }

    QSize sizeHint() const override { return widget()->sizeHint(); }
    QSize minimumSizeHint() const override
    {
        constexpr QSize kLeast(38 * kGrid, 14 * kGrid);
        const QSize wanted = widget()->minimumSizeHint();
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
