// The actions of the window that stand in no menu: those that the panels and bars publish by QWidget::addAction(), and those of
// the docks and the map. Makes their shortcuts work in the whole window, and lists them for the command palette. Lives on the
// GUI thread.
#pragma once

#include <QtCore/QList>
#include <QtCore/QObject>
#include <QtCore/QPointer>
#include <QtCore/QString>

#include <vector>

class QAction;
class QWidget;

namespace skyseal::ui {

class Shortcuts;

class WindowActions : public QObject
{
    Q_OBJECT

public:
    struct Group
    {
        QString title; ///< of the panel or bar
        QList<QPointer<QAction>> actions;
    };

    /// `window` becomes the parent; `shortcuts` must outlive this.
    WindowActions(QWidget &window, Shortcuts &shortcuts);

    /// Takes over the actions that have an object name, with their shortcuts. They must live as long as the window.
    void add(const QString &title, const QList<QAction *> &actions);
    /// Actions that end with their bar. They can have no shortcut.
    void addPassing(const QString &title, const QList<QAction *> &actions);
    /// As they are possible now. Actions that have ended are null.
    const std::vector<Group> &groups();

private:
    QWidget &m_window;
    Shortcuts &m_shortcuts;
    std::vector<Group> m_groups;
};

} // namespace skyseal::ui
