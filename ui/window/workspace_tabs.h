// The workspaces as buttons at the left of the status strip. Lives on the GUI thread.
#pragma once

#include <QtWidgets/QWidget>

namespace skyseal::ui {

class Workspaces;

class WorkspaceTabs : public QWidget
{
    Q_OBJECT

public:
    WorkspaceTabs(const Workspaces &workspaces, QWidget *parent);
};

} // namespace skyseal::ui
