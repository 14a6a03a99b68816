// Panel with the table of links and buttons to add and remove one. Main thread.
#pragma once

#include "ui/links/link_model.h"
#include "ui/dock_panel.h"
#include "ui/view_state.h"

class QPushButton;
class QTreeView;

namespace skyseal::ui {

class LinksPanel : public DockPanel
{
    Q_OBJECT

public:
    explicit LinksPanel(StationInterface &station, QWidget *parent = nullptr);

    void showViewState(const ViewState &view) override;

Q_SIGNALS:
    void addRequested();

private:
    StationInterface &m_station;
    LinkModel m_model;
    QTreeView *m_view;
    QPushButton *m_remove;
    double m_shownAt = -1;
};

} // namespace skyseal::ui
