// The shortcuts of the actions in the menus and of those that panels publish. The operator's choices are kept by the object
// name of each action, as "shortcuts/ID" in the settings; all other actions have their first shortcut. Lives on the GUI thread.
#pragma once

#include <QtCore/QObject>
#include <QtGui/QKeySequence>

#include <optional>
#include <vector>

class QAction;
class QMenuBar;
class QSettings;

namespace skyseal::ui {

class Shortcuts : public QObject
{
    Q_OBJECT

public:
    struct Item
    {
        QAction *action;
        QString menu;                       ///< title of the menu or panel that the action is in
        QKeySequence first;                 ///< of the program
        std::optional<QKeySequence> chosen; ///< by the operator; empty keys: no shortcut
    };

    /// `store` must outlive this.
    Shortcuts(QSettings &store, QObject *parent);

    /// Takes over all actions of the menus that have an object name, with their present shortcuts as the first ones, and gives
    /// them the stored ones. Stored keys of other names stay; invalid or refused keys are ignored. The actions must
    /// outlive this. Entries of menus that fill themselves, such as the modes of a vehicle, have no name and no shortcut.
    void take(const QMenuBar &bar);
    /// As above, for the actions of a panel or bar. Those that are menus have no shortcut.
    void take(const QString &title, const QList<QAction *> &actions);

    const std::vector<Item> &items() const { return m_items; }
    /// Title of an action as a text.
    QString name(int item) const;
    QKeySequence keys(int item) const;
    /// The item that has these keys; -1: none.
    int ownerOf(const QKeySequence &keys) const;

    /// Gives an action these keys, which shortcutRefusal() permits, or none. An action that has them loses them.
    void choose(int item, const QKeySequence &keys);
    void resetAll();

Q_SIGNALS:
    void changed();

private:
    void setChosen(Item &item, const QKeySequence &keys);
    void apply();

    QSettings &m_store;
    std::vector<Item> m_items;
};

} // namespace skyseal::ui
