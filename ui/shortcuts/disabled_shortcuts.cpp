#include "ui/shortcuts/disabled_shortcuts.h"

#include "ui/shortcuts/shortcuts.h"

#include <QtGui/QAction>
#include <QtGui/QShortcut>
#include <QtWidgets/QWidget>

namespace skyseal::ui {

namespace {

/// Empty if the action is possible, cannot be seen or does not say why not.
QString reasonAgainst(const QAction &action)
{
    return action.isVisible() && !action.isEnabled() ? action.statusTip() : QString();
}

} // namespace

DisabledShortcuts::DisabledShortcuts(const Shortcuts &shortcuts, QWidget &window) : QObject(&window)
{
    for (int i = 0; i < static_cast<int>(shortcuts.items().size()); ++i) {
        QAction *action = shortcuts.items()[static_cast<std::size_t>(i)].action;
        auto *keys = new QShortcut(&window); // has the keys of the action while that is disabled
        keys->setAutoRepeat(false);
        const auto follow = [keys, action] {
            if (keys->key() != action->shortcut())
                keys->setKey(action->shortcut());
            keys->setEnabled(!reasonAgainst(*action).isEmpty());
        };
        follow();
        connect(action, &QAction::changed, keys, follow);
        connect(keys, &QShortcut::activated, this, [this, &shortcuts, i, action] {
            const QString reason = reasonAgainst(*action);
            QString name = shortcuts.name(i);
            if (name.endsWith(QChar(0x2026)))
                name.chop(1);
            if (reason != name)
                Q_EMIT refused(reason.startsWith(name) ? reason : tr("%1: %2").arg(name, reason));
        });
    }
}

} // namespace skyseal::ui

#include "moc_disabled_shortcuts.cpp"
