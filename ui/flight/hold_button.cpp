#include "ui/flight/hold_button.h"

#include "ui/held_keys.h"
#include "ui/theme/grid.h"

#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>

#include <algorithm>

namespace skyseal::ui {

HoldButton::HoldButton(const QString &text, QWidget *parent, int holdMs) : QPushButton(text, parent), m_holdMs(holdMs)
{
    m_how = holdMs == kHoldMs ? tr("Hold for half a second to confirm; Escape aborts")
                              : tr("Hold for %1 s to confirm; Escape aborts").arg(holdMs / 1000.0);
    setDisabledReason({});
    setAutoDefault(false);
    m_ticker.setInterval(16);
    connect(&m_ticker, &QTimer::timeout, this, &HoldButton::tick);
    connect(&HeldKeys::ofProgram(), &HeldKeys::released, this, [this](int key) {
        if (key == m_key)
            abort();
    });
}

void HoldButton::setDisabledReason(const QString &sentence)
{
    if (!sentence.isEmpty() && parentWidget() && window()->focusWidget() == this)
        parentWidget()->setFocus(Qt::OtherFocusReason);
    setEnabled(sentence.isEmpty());
    const QString hold = tr("Hold to confirm (mouse, Space or Enter); Esc aborts");
    const QString tip = !sentence.isEmpty() ? sentence : m_purpose.isEmpty() ? hold : m_purpose + QLatin1Char('\n') + hold;
    if (toolTip() != tip)
        setToolTip(tip);
    const QString description = sentence.isEmpty() ? m_how : sentence;
    if (accessibleDescription() != description)
        setAccessibleDescription(description);
}

void HoldButton::setCommand(const QString &text, const QString &spoken)
{
    if (this->text() != text)
        setText(text);
    if (accessibleName() != spoken) // a screen reader would say it again
        setAccessibleName(spoken);
}

void HoldButton::setPurpose(const QString &sentence)
{
    if (sentence == m_purpose)
        return;
    m_purpose = sentence;
    if (isEnabled())
        setDisabledReason({}); // the tool tip
}

int HoldButton::roomFor(const QString &text) const
{
    return fontMetrics().size(Qt::TextShowMnemonic, text).width() + 2 * kGrid;
}

int HoldButton::heightFor(const QString &text) const
{
    const auto linesOf = [this](const QString &words) { return fontMetrics().size(Qt::TextShowMnemonic, words).height(); };
    return QPushButton::sizeHint().height() - linesOf(this->text()) + linesOf(text);
}

QSize HoldButton::sizeHint() const
{
    return {roomFor(text()), QPushButton::sizeHint().height()};
}

void HoldButton::begin(int key)
{
    if (!isEnabled() || isHeld())
        return;
    m_key = key;
    m_since.start();
    m_ticker.start();
    setDown(true);
}

void HoldButton::abort()
{
    if (!isHeld())
        return;
    m_ticker.stop();
    m_progress = 0;
    m_key = 0;
    setDown(false);
    update();
    Q_EMIT aborted();
}

void HoldButton::tick()
{
    m_progress = std::min(1.0, static_cast<double>(m_since.elapsed()) / m_holdMs);
    update();
    if (m_progress < 1.0)
        return;
    if (m_key != 0 && !HeldKeys::ofProgram().isDown(m_key))
        return; // it may just have been released
    m_ticker.stop();
    m_progress = 0;
    m_key = 0;
    setDown(false);
    m_guard.noteCommand();
    Q_EMIT confirmed();
}

void HoldButton::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        begin(0);
    event->accept();
}

void HoldButton::mouseReleaseEvent(QMouseEvent *event)
{
    abort();
    event->accept();
}

void HoldButton::mouseMoveEvent(QMouseEvent *event)
{
    if (!hitButton(event->pos()))
        abort();
    event->accept();
}

void HoldButton::keyPressEvent(QKeyEvent *event)
{
    if (HeldKeys::isPressKey(event->key())) {
        begin(event->key()); // the guard lets fresh presses pass only
        event->accept();
    } else if (event->key() == Qt::Key_Escape && isHeld()) {
        abort();
        event->accept();
    } else {
        event->ignore();
    }
}

void HoldButton::keyReleaseEvent(QKeyEvent *event)
{
    event->accept(); // HeldKeys tells when the key is really up
}

void HoldButton::focusOutEvent(QFocusEvent *event)
{
    abort();
    QPushButton::focusOutEvent(event);
}

void HoldButton::hideEvent(QHideEvent *event)
{
    abort();
    QPushButton::hideEvent(event);
}

void HoldButton::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::EnabledChange && !isEnabled())
        abort();
    QPushButton::changeEvent(event);
}

void HoldButton::paintEvent(QPaintEvent *event)
{
    QPushButton::paintEvent(event);
    if (m_progress <= 0)
        return;
    QPainter painter(this);
    QColor fill = palette().color(QPalette::Highlight);
    painter.fillRect(QRectF(2, height() - 5, (width() - 4) * m_progress, 3), fill);
    fill.setAlphaF(0.18f);
    painter.fillRect(QRectF(2, 2, (width() - 4) * m_progress, height() - 4), fill);
}

} // namespace skyseal::ui

#include "moc_hold_button.cpp"
