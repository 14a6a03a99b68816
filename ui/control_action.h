// Actions that stand for the controls of panels and bars: the command palette finds them, and each can have a shortcut. An
// action operates its control, so that both always do the same. Lives on the GUI thread.
#pragma once

#include <QtGui/QAction>

#include <functional>

class QAbstractButton;

namespace skyseal::ui {

/// Possible while its control is enabled, with the control's tool tip as the reason if not; invisible while the control is
/// hidden. A control in a dock that is hidden counts as visible: the action shows the dock first.
class ControlAction : public QAction
{
    Q_OBJECT

public:
    /// Becomes a child of `control`. `act` is called if the control is enabled and visible at that time.
    ControlAction(QWidget &control, const QString &id, const QString &text, const QKeySequence &keys,
                  std::function<void()> act);

    /// Adopts what changes without an event: the name of the control, and whether the widgets around it are visible.
    void refresh();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    friend QAction *pressAction(QAbstractButton &, const QKeySequence &);

    void perform();
    bool isShown() const;

    QWidget &m_control;
    std::function<void()> m_act;
    QAbstractButton *m_button = nullptr; ///< whose name is the text, and whose state is shown
};

/// Presses `button`. Its text is the accessible name of the button; its id is "press_" and the button's object name.
QAction *pressAction(QAbstractButton &button, const QKeySequence &keys = {});
/// Moves the focus to `control`, for all that is typed, or guarded against slips. Its id is "focus_" and the object name.
QAction *focusAction(QWidget &control, const QString &text, const QKeySequence &keys = {});

} // namespace skyseal::ui
