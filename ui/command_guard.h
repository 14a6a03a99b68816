// Lets a control that sends commands act only on a press that was meant for it: a key that was already down when the control
// got the focus does nothing, and after a command the control stays quiet for a moment. Used by every control that commands a
// vehicle or gives a consent.
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
    bool isQuiet() const { return !m_quiet.hasExpired(); }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QDeadlineTimer m_quiet{0};
};

} // namespace skyseal::ui
