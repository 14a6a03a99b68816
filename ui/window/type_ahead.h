// Chooses among the entries of a menu by typing how they begin, as in a list: menus that are filled from a vehicle, such as its
// modes, have no mnemonics. Lives on the GUI thread.
#pragma once

#include <QtCore/QElapsedTimer>
#include <QtCore/QObject>

class QMenu;

namespace skyseal::ui {

class TypeAhead : public QObject
{
    Q_OBJECT

public:
    /// Does nothing while an entry of `menu` has a mnemonic. Becomes its child.
    explicit TypeAhead(QMenu &menu);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// Makes the next entry that begins with the typed text the active one.
    void find();

    QMenu &m_menu;
    QString m_typed;
    QElapsedTimer m_since; ///< the last letter
};

} // namespace skyseal::ui
