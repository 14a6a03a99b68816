#include "ui/shortcuts/shortcuts.h"

#include "ui/shortcuts/shortcut_rules.h"
#include "ui/text/menu_text.h"

#include <QtCore/QSet>
#include <QtCore/QSettings>
#include <QtGui/QAction>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>

#include <algorithm>

namespace skyseal::ui {

namespace {

const QString kShortcutGroup = QStringLiteral("shortcuts");

QString storeKey(const QAction &action)
{
    return kShortcutGroup + QLatin1Char('/') + action.objectName();
}

/// The stored keys of an action; nullopt if nothing is stored, or what is stored cannot be a shortcut.
std::optional<QKeySequence> storedKeys(const QSettings &store, const QAction &action)
{
    const QVariant value = store.value(storeKey(action));
    if (!value.isValid())
        return std::nullopt;
    const QString text = value.toString();
    const auto keys = QKeySequence::fromString(text, QKeySequence::PortableText);
    if (keys.isEmpty() != text.isEmpty() || !shortcutRefusal(keys).isEmpty())
        return std::nullopt;
    return keys;
}

} // namespace

Shortcuts::Shortcuts(QSettings &store, QObject *parent) : QObject(parent), m_store(store) {}

void Shortcuts::take(const QMenuBar &bar)
{
    for (const QAction *top : bar.actions()) {
        if (const QMenu *menu = top->menu())
            take(withoutMnemonic(top->text()), menu->actions());
    }
}

void Shortcuts::take(const QString &title, const QList<QAction *> &actions)
{
    for (QAction *action : actions) {
        if (!action->objectName().isEmpty() && !action->isSeparator() && !action->menu())
            m_items.push_back({action, title, action->shortcut(), storedKeys(m_store, *action)});
    }
    apply();
}

QString Shortcuts::name(int item) const
{
    const QString text = withoutMnemonic(m_items[static_cast<std::size_t>(item)].action->text());
    return text.section(QStringLiteral(" · "), 0, 0); // without the state of a cipher suite
}

QKeySequence Shortcuts::keys(int item) const
{
    return m_items[static_cast<std::size_t>(item)].action->shortcut();
}

int Shortcuts::ownerOf(const QKeySequence &keys) const
{
    if (keys.isEmpty())
        return -1;
    const auto found = std::ranges::find_if(m_items, [&](const Item &item) { return item.action->shortcut() == keys; });
    return found == m_items.end() ? -1 : static_cast<int>(found - m_items.begin());
}

void Shortcuts::choose(int item, const QKeySequence &keys)
{
    if (const int owner = ownerOf(keys); owner >= 0 && owner != item)
        setChosen(m_items[static_cast<std::size_t>(owner)], {});
    setChosen(m_items[static_cast<std::size_t>(item)], keys);
    apply();
    Q_EMIT changed();
}

void Shortcuts::resetAll()
{
    m_store.remove(kShortcutGroup);
    for (Item &item : m_items)
        item.chosen.reset();
    apply();
    Q_EMIT changed();
}

void Shortcuts::setChosen(Item &item, const QKeySequence &keys)
{
    if (keys == item.first) {
        item.chosen.reset();
        m_store.remove(storeKey(*item.action));
    } else {
        item.chosen = keys;
        m_store.setValue(storeKey(*item.action), keys.toString(QKeySequence::PortableText));
    }
}

/// The operator's choices come before the first shortcuts, which a later version may have changed. Of actions that would
/// share their keys, the first one gets them: Qt would obey none of them.
void Shortcuts::apply()
{
    QSet<QKeySequence> used;
    for (const bool chosen : {true, false}) {
        for (Item &item : m_items) {
            if (item.chosen.has_value() != chosen)
                continue;
            const QKeySequence keys = item.chosen.value_or(item.first);
            const bool isFree = keys.isEmpty() || !used.contains(keys);
            item.action->setShortcut(isFree ? keys : QKeySequence());
            used.insert(keys);
        }
    }
}

} // namespace skyseal::ui

#include "moc_shortcuts.cpp"
