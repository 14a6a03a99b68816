#include "ui/held_keys.h"

#include <QtCore/QTimer>
#include <QtGui/QGuiApplication>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QAbstractButton>

#include <utility>

namespace skyseal::ui {

HeldKeys &HeldKeys::ofProgram()
{
    if (auto *present = qApp->findChild<HeldKeys *>(QString(), Qt::FindDirectChildrenOnly))
        return *present;
    auto *made = new HeldKeys(qApp);
    qApp->installEventFilter(made);
    return *made;
}

bool HeldKeys::isPressKey(int key)
{
    return key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Select;
}

/// Buttons that repeat by themselves, such as those that scroll, take every press.
static bool isPressed(const QObject *watched, const QKeyEvent &press)
{
    const auto *button = qobject_cast<const QAbstractButton *>(watched);
    return button && !button->autoRepeat() && HeldKeys::isPressKey(press.key());
}

bool HeldKeys::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::KeyPress: {
        const auto &press = *static_cast<const QKeyEvent *>(event);
        notePress(press);
        if (isFresh(press) && watched->isWidgetType() && !m_pressedIn.contains(press.key()))
            m_pressedIn.insert(press.key(), watched); // not its parents, which get what it does not take
        return isPressed(watched, press) && m_isHeld && !isFresh(press) && m_pressedIn.value(press.key()) != watched;
    }
    case QEvent::KeyRelease: noteRelease(*static_cast<const QKeyEvent *>(event)); break;
    case QEvent::FocusOut:
        if (watched->isWidgetType())
            m_left = static_cast<const QWidget *>(watched);
        break;
    case QEvent::ApplicationStateChange:
        if (QGuiApplication::applicationState() != Qt::ApplicationActive)
            releaseAll(); // their releases go to another program
        break;
    default: break;
    }
    return false;
}

bool HeldKeys::continuesHold(const QKeyEvent &press) const
{
    if (press.isAutoRepeat() || m_down.contains(press.key()))
        return true;
    const auto last = m_releases.constFind(press.key());
    if (last == m_releases.constEnd())
        return false;
    if (last->timestamp == 0 || press.timestamp() == 0)
        return last->pending;
    return press.timestamp() - last->timestamp < kRepeatGapMs;
}

bool HeldKeys::isFresh(const QKeyEvent &press) const
{
    return &press == m_fresh && press.timestamp() == m_freshAt && !press.isAutoRepeat();
}

/// The same event passes several times, on its way from the window to the widget and to the parents of the widget.
void HeldKeys::notePress(const QKeyEvent &press)
{
    if (isFresh(press))
        return;
    const int key = press.key();
    const bool held = continuesHold(press);
    const bool hasTimes = press.timestamp() != 0; // otherwise a release that is pending tells too little to take a press away
    m_isHeld = held && (hasTimes || press.isAutoRepeat() || m_down.contains(key));
    const Release last = std::exchange(m_releases[key].pending, false) ? m_releases[key] : Release{};
    m_down.insert(key);
    if (!held)
        m_pressedIn.remove(key);
    m_fresh = held ? nullptr : &press;
    m_freshAt = press.timestamp();
    if (!held && last.number != 0)
        Q_EMIT released(key); // the event loop was too slow to tell it before
}

void HeldKeys::noteRelease(const QKeyEvent &release)
{
    m_fresh = nullptr;
    if (release.isAutoRepeat())
        return;
    const int key = release.key();
    m_down.remove(key);
    const Release last{release.timestamp(), ++m_number, true};
    m_releases.insert(key, last);
    QTimer::singleShot(kRepeatGapMs, this, [this, key, number = last.number] {
        Release &now = m_releases[key];
        if (now.number == number && std::exchange(now.pending, false))
            Q_EMIT released(key);
    });
}

void HeldKeys::releaseAll()
{
    m_fresh = nullptr;
    m_releases.clear();
    for (const int key : std::exchange(m_down, {}))
        Q_EMIT released(key);
}

} // namespace skyseal::ui

#include "moc_held_keys.cpp"
