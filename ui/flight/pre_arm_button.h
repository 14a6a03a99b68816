// Shows beside Arm whether the vehicle's pre-arm checks pass, and opens the list of the reasons. Sends nothing.
#pragma once

#include "ui/view_state.h"

#include <QtWidgets/QPushButton>

namespace skyseal::ui {

class VehicleCommands;

class PreArmButton : public QPushButton
{
    Q_OBJECT

public:
    explicit PreArmButton(VehicleCommands &commands, QWidget *parent = nullptr);

    void showViewState(const ViewState &view);
    /// Width in pixels for every state, on one line or two.
    int leastWidth(bool onTwoLines) const;
    void setOnTwoLines(bool on);

Q_SIGNALS:
    /// For the list, if it is open.
    void viewChanged(const skyseal::ui::ViewState &view);

private:
    void openList();
    static QString lines(QString text, bool onTwoLines);

    VehicleCommands &m_commands;
    ViewState m_view;
    bool m_onTwoLines = false;
};

} // namespace skyseal::ui
