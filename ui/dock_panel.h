// A panel in a dock that knows whether anybody can see it: a dock behind another tab is still "visible" to Qt, and what
// costs time must not run there.
#pragma once

#include <QtWidgets/QWidget>

namespace skyseal::ui {

class DockPanel : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    bool isSeen() const { return m_seen; }
    /// Whether the dock's tab is in front; true for a panel that stands alone.
    void setInFront(bool inFront)
    {
        m_inFront = inFront;
        judge();
    }

protected:
    /// Called once for each change.
    virtual void seenChanged(bool seen) = 0;

    void showEvent(QShowEvent *event) override
    {
        QWidget::showEvent(event);
        judge();
    }
    void hideEvent(QHideEvent *event) override
    {
        QWidget::hideEvent(event);
        judge();
    }

private:
    void judge()
    {
        const bool seen = m_inFront && isVisible();
        if (seen != m_seen) {
            m_seen = seen;
            seenChanged(seen);
        }
    }

    bool m_inFront = true, m_seen = false;
};

} // namespace skyseal::ui
