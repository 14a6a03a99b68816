#include "ui/window/type_ahead.h"

#include <QtGui/QAction>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QMenu>

#include <algorithm>

namespace skyseal::ui {

TypeAhead::TypeAhead(QMenu &menu) : QObject(&menu), m_menu(menu)
{
    menu.installEventFilter(this);
    connect(&menu, &QMenu::aboutToShow, this, [this] { m_since.invalidate(); });
}

bool TypeAhead::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return QObject::eventFilter(watched, event);
    const auto &key = *static_cast<QKeyEvent *>(event);
    const QString text = key.text();
    const bool isTyped = !text.isEmpty() && text.front().isPrint() && text.front() != QLatin1Char(' ');
    if (!isTyped || (key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
        || std::ranges::any_of(m_menu.actions(), [](const QAction *entry) { return entry->text().contains(QLatin1Char('&')); }))
        return false;
    const bool begins = !m_since.isValid() || m_since.elapsed() > QApplication::keyboardInputInterval();
    m_since.start();
    m_typed = begins ? text : m_typed + text;
    find();
    return true;
}

void TypeAhead::find()
{
    const bool isOneLetter = m_typed.count(m_typed.front(), Qt::CaseInsensitive) == m_typed.size();
    const QString sought = isOneLetter ? m_typed.left(1) : m_typed; // the same letter again leads to the next entry
    const QList<QAction *> entries = m_menu.actions();
    const qsizetype active = entries.indexOf(m_menu.activeAction());
    const qsizetype from = isOneLetter ? active + 1 : std::max<qsizetype>(active, 0);
    for (qsizetype i = 0; i < entries.size(); ++i) {
        QAction *entry = entries[(from + i) % entries.size()];
        if (entry->isEnabled() && entry->isVisible() && entry->text().startsWith(sought, Qt::CaseInsensitive))
            return m_menu.setActiveAction(entry);
    }
}

} // namespace skyseal::ui

#include "moc_type_ahead.cpp"
