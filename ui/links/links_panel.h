// Panel with the table of links, buttons to add and remove one, and the switch that serves other stations. Main thread.
#pragma once

#include "ui/links/gateway_section.h"
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
    void applySettings(const Settings &settings) override;

Q_SIGNALS:
    void addRequested();
    void servingChanged(const skyseal::ui::Serving &serving);
    /// See GatewaySection.
    void sharingChanged(const QString &word, const QString &sentence);

private:
    void removeChosen();

    StationInterface &m_station;
    SnapshotPtr m_shown; ///< the newest one of the station
    LinkModel m_model;
    QTreeView *m_view;
    QPushButton *m_remove;
    GatewaySection *m_gateway;
    double m_shownAt = -1;
};

} // namespace skyseal::ui
