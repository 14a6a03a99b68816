// Base of all panels in docks: the updates that a panel can follow, and whether it is visible to the operator. A dock behind
// another tab counts as visible for Qt, but a panel must not spend CPU time there.
#pragma once

#include <QtWidgets/QWidget>

namespace skyseal::ui {

struct Settings;
struct ViewState;

/// A panel overrides the updates that it needs. All are called on the GUI thread.
class DockPanel : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// For each snapshot, up to 30 times a second.
    virtual void onSnapshot(const ViewState & /*view*/) {}
    /// Numbers and lists: up to 5 times a second, and at once when an alarm changes.
    virtual void showViewState(const ViewState & /*view*/) {}
    virtual void applySettings(const Settings & /*settings*/) {}
    /// The dock's height in pixels, for panels that scroll as a whole: a panel can hide what matters least before it has to
    /// scroll.
    virtual void fitHeight(int /*height*/) {}
    /// Whether its dock scrolls the whole panel; a panel of lists or charts scrolls or fits those itself.
    virtual bool scrollsAsAWhole() const { return false; }

    /// True if the panel is visible and in front of its tabs.
    bool isExposed() const { return m_exposed; }
    /// Whether the dock's tab is in front; true for a panel without a dock.
    void setInFront(bool inFront)
    {
        m_inFront = inFront;
        updateExposed();
    }

protected:
    /// Called once for each change of isExposed().
    virtual void exposedChanged(bool /*exposed*/) {}

    void showEvent(QShowEvent *event) override
    {
        QWidget::showEvent(event);
        updateExposed();
    }
    void hideEvent(QHideEvent *event) override
    {
        QWidget::hideEvent(event);
        updateExposed();
    }

private:
    void updateExposed()
    {
        const bool exposed = m_inFront && isVisible();
        if (exposed != m_exposed) {
            m_exposed = exposed;
            exposedChanged(exposed);
        }
    }

    bool m_inFront = true, m_exposed = false;
};

} // namespace skyseal::ui
