// The dialog with the files that are drawn over the map: add, show or hide, choose a colour, remove. All takes effect at once.
#pragma once

#include <QtWidgets/QDialog>

class QComboBox;
class QLabel;
class QPushButton;
class QTreeView;

namespace skyseal::ui {

class OverlayModel;

class OverlayDialog : public QDialog
{
    Q_OBJECT

public:
    /// `model` must outlive the dialog.
    explicit OverlayDialog(OverlayModel &model, QWidget *parent = nullptr);

private:
    void chooseFiles();
    void add(const QStringList &files);
    void removeSelected();
    int row() const; ///< the selected one; -1: none
    void refresh();

    OverlayModel &m_model;
    QTreeView *m_view;
    QLabel *m_state;
    QComboBox *m_color;
    QPushButton *m_remove, *m_again;
    bool m_isFull = false; ///< a file was not added
};

} // namespace skyseal::ui
