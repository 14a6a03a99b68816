// A button that acts only after it was held for half a second, by mouse, Space or Enter: for what moves a vehicle. Letting
// go early, leaving the button, losing the focus or pressing Esc means no.
#pragma once

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>
#include <QtWidgets/QPushButton>

namespace skyseal::ui {

class HoldButton : public QPushButton
{
    Q_OBJECT

public:
    static constexpr int kHoldMs = 500;

    explicit HoldButton(const QString &text, QWidget *parent = nullptr);

    /// Disabled while there is a reason, a sentence that is the tool tip then; enabled when it is empty.
    void setWhyNot(const QString &sentence);
    /// How far the hold is, 0 … 1; 0 when nobody holds.
    double progress() const { return m_progress; }
    bool isHeld() const { return m_ticker.isActive(); }
    /// Ends a hold as a no: what the button would do is not what it was pressed for any more.
    void abort();

Q_SIGNALS:
    void confirmed();
    /// Let go before the time was over, so that a hint can say how it works.
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
    void begin();
    void tick();

    QTimer m_ticker;
    QElapsedTimer m_since;
    double m_progress = 0;
};

} // namespace skyseal::ui
