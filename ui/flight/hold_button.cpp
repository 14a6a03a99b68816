#include "ui/flight/hold_button.h"

#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>

#include <algorithm>

namespace skyseal::ui {

namespace {

bool isHoldKey(int key)
{
    return key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Select;
}

} // namespace

HoldButton::HoldButton(const QString &text, QWidget *parent) : QPushButton(text, parent)
{
    setAccessibleDescription(tr("Hold for half a second to confirm; Escape aborts"));
    setDisabledReason({});
    setAutoDefault(false);
    m_ticker.setInterval(16);
    connect(&m_ticker, &QTimer::timeout, this, &HoldButton::tick);
}

void HoldButton::setDisabledReason(const QString &sentence)
{
    setEnabled(sentence.isEmpty());
    const QString tip = sentence.isEmpty() ? tr("Hold to confirm (mouse, Space or Enter); Esc aborts") : sentence;
    if (toolTip() != tip)
        setToolTip(tip);
}

void HoldButton::begin()
{
    if (!isEnabled() || isHeld())
        return;
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
    setDown(false);
    update();
    Q_EMIT aborted();
}

void HoldButton::tick()
{
    m_progress = std::min(1.0, static_cast<double>(m_since.elapsed()) / kHoldMs);
    update();
    if (m_progress < 1.0)
        return;
    m_ticker.stop();
    m_progress = 0;
    setDown(false);
    Q_EMIT confirmed();
}

void HoldButton::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        begin();
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
    if (isHoldKey(event->key())) {
        if (!event->isAutoRepeat())
            begin();
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
    if (isHoldKey(event->key()) && !event->isAutoRepeat())
        abort();
    event->accept();
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
