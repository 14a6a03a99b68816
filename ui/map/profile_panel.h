// The panel with the altitude profile of the vehicle's mission. Lives on the GUI thread.
#pragma once

#include "core/vehicle/mission.h"
#include "ui/dock_panel.h"

class QLabel;
class QStackedWidget;

namespace skyseal::ui {

class ProfileView;

class ProfilePanel : public DockPanel
{
    Q_OBJECT

public:
    explicit ProfilePanel(QWidget *parent = nullptr);

    void showViewState(const ViewState &view) override;
    void applySettings(const Settings &settings) override;

private:
    QStackedWidget *m_pages; ///< the reason why there is no profile, or the profile
    QLabel *m_empty;
    ProfileView *m_view;
    std::shared_ptr<const std::vector<vehicle::MissionItem>> m_mission;
    std::optional<QPointF> m_home;
    double m_homeAltitude = 0;
    int m_current = -1;
};

} // namespace skyseal::ui
