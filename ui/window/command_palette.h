// Finds any entry of the menus, and any action of the panels and bars, by typing parts of its name, and chooses it. Lives
// on the GUI thread.
#pragma once

#include <QtCore/QPointer>
#include <QtWidgets/QDialog>

#include <vector>

class QAction;
class QLabel;
class QLineEdit;
class QMainWindow;
class QMenu;
class QStandardItemModel;
class QTreeView;

namespace skyseal::ui {

class WindowActions;

class CommandPalette : public QDialog
{
    Q_OBJECT

public:
    /// Opens a palette over the menus of `window` and its other actions as they are now, or raises the one that is open.
    static void open(QMainWindow &window, WindowActions &others);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    CommandPalette(QMainWindow &window, WindowActions &others);
    void collect(QMenu &menu, const QString &path);
    void collect(QAction &action, const QString &path);
    void add(QAction &action, const QString &path);
    void filter(const QString &typed);
    void choose();

    QLineEdit *m_typed;
    QTreeView *m_list;
    QLabel *m_none; ///< shown where nothing is listed
    QStandardItemModel *m_model;
    std::vector<QPointer<QAction>> m_actions; ///< of the rows; menus that fill themselves again delete theirs
};

} // namespace skyseal::ui
