// Lets a control that sends commands act only on a press that was meant for it: a key that was already down when the control
// got the focus does nothing, and after a command the control stays quiet for a moment. Used by every control that commands a
// vehicle or gives a consent.
//
// Such a control has the focus only where the operator or the program put it. Qt gives the focus of a widget that is hidden,
// disabled or destroyed to the next one in the order of the tab key, and a window that is active again gives it to the control
// that had it before: the operator's next press of Space, meant for what was there, would arm. The guard hands that focus on.
#pragma once

#include <QtCore/QDeadlineTimer>
#include <QtCore/QObject>

class QWidget;

namespace skyseal::ui {

class CommandGuard : public QObject
{
    Q_OBJECT

public:
    /// Milliseconds after a command in which the control ignores presses.
    static constexpr int kQuietMs = 600;

    /// Becomes a child of `control` and filters its events. The click of a button counts as its command.
    explicit CommandGuard(QWidget &control);

    /// The control has sent its command.
    void noteCommand();
    /// The operator has chosen the control while another window was active, which receives no event of it.
    void noteChoice() { m_lapsed = false; }
    bool isQuiet() const { return !m_quiet.hasExpired(); }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// To the central widget of a main window, which may have a proxy for it, else to the window itself.
    void handFocusOn() const;

    bool isDeliberate(Qt::FocusReason reason) const;

    QWidget &m_control;
    bool m_lapsed = false; ///< the window became inactive while the control had the focus, and nobody has chosen it since
    QDeadlineTimer m_quiet{0};
};

} // namespace skyseal::ui
