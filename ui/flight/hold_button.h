// A button for commands that move a vehicle: it acts only after it was held for half a second, by mouse, Space or Enter.
// Releasing early, leaving the button, losing the focus or pressing Esc aborts. A hold begins with a fresh press: a key that
// was down before does nothing. A button that is disabled while it has the focus leaves it to its parent, not to the next
// button, which the operator's next key would press.
#pragma once

#include "ui/command_guard.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>
#include <QtWidgets/QPushButton>

namespace skyseal::ui {

class HoldButton : public QPushButton
{
    Q_OBJECT

public:
    static constexpr int kHoldMs = 500;

    /// `holdMs`: how long it must be held, in milliseconds.
    explicit HoldButton(const QString &text, QWidget *parent = nullptr, int holdMs = kHoldMs);

    /// Shows the command as `text`, and says it to screen readers as `spoken`.
    void setCommand(const QString &text, const QString &spoken);
    /// Says what the button does, at the beginning of its tool tip while it is enabled. A whole sentence.
    void setPurpose(const QString &sentence);
    /// Disables the button with this sentence as its tool tip and description; enables it if the sentence is empty.
    void setDisabledReason(const QString &sentence);
    /// Returns the progress of the hold, 0 … 1; 0 if the button is not held.
    double progress() const { return m_progress; }
    bool isHeld() const { return m_ticker.isActive(); }
    /// Aborts a hold because the meaning of the button has changed.
    void abort();

    /// Width in pixels that the button needs for a text: that of its widest line.
    int roomFor(const QString &text) const;
    /// Height in pixels that the button needs for the lines of a text.
    int heightFor(const QString &text) const;
    /// As wide as its text needs: the usual least width of buttons has no room in a row of many.
    QSize sizeHint() const override;

Q_SIGNALS:
    void confirmed();
    /// The button was released too early.
    void aborted();

protected:
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    /// `key`: the key that holds it, 0 for the mouse.
    void begin(int key);
    void tick();

    const int m_holdMs;
    QString m_purpose;
    QString m_how; ///< for screen readers: how it is confirmed
    QTimer m_ticker;
    QElapsedTimer m_since;
    double m_progress = 0;
    int m_key = 0; ///< that holds it; 0: the mouse, or nothing
    CommandGuard m_guard{*this};
};

} // namespace skyseal::ui
