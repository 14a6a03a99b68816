// The dialog in which the operator gives keys to the actions of the menus. All takes effect at once; an action loses its keys
// to another one only by a press of Replace. Lives on the GUI thread.
#pragma once

#include <QtGui/QKeySequence>
#include <QtWidgets/QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeView;

namespace skyseal::ui {

class ShortcutEdit;
class ShortcutModel;
class Shortcuts;

class ShortcutDialog : public QDialog
{
    Q_OBJECT

public:
    /// `shortcuts` must outlive the dialog.
    explicit ShortcutDialog(Shortcuts &shortcuts, QWidget *parent = nullptr);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QLayout *makeKeys();
    QLayout *makeButtons();
    int row() const; ///< the selected one; -1: none
    void filter(const QString &typed);
    void showRow();
    void request(const QKeySequence &keys);
    void assign(const QKeySequence &keys);
    void askResetAll();

    Shortcuts &m_shortcuts;
    ShortcutModel *m_model;
    QLineEdit *m_find;
    QTreeView *m_view;
    QLabel *m_of, *m_note;
    ShortcutEdit *m_keys;
    QPushButton *m_replace, *m_none, *m_reset;
    QKeySequence m_requested; ///< keys of another action, until Replace is pressed
};

} // namespace skyseal::ui
