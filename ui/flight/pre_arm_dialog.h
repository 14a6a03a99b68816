// The list of the reasons for which the shown vehicle would not arm, each with what to do, and its
// checklist. Stays open beside the window and
// follows the vehicle.
#pragma once

#include "ui/view_state.h"

#include <QtWidgets/QDialog>

class QLabel;
class QListWidget;
class QPushButton;

namespace skyseal::ui {

class ChecklistBox;
class VehicleCommands;

class PreArmDialog : public QDialog
{
    Q_OBJECT

public:
    explicit PreArmDialog(VehicleCommands &commands, QWidget *parent = nullptr);

    void showViewState(const ViewState &view);

private:
    QLabel *m_state;
    QListWidget *m_list;
    QPushButton *m_check;
    ChecklistBox *m_checklist;
    std::uint8_t m_systemId = 0;
};

} // namespace skyseal::ui
