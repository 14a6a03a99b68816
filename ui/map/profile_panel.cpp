#include "ui/map/profile_panel.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/map/profile_view.h"
#include "ui/settings.h"
#include "ui/theme/grid.h"
#include "ui/view_state.h"

#include <QtWidgets/QLabel>
#include <QtWidgets/QStackedWidget>
#include <QtWidgets/QVBoxLayout>

#include <cmath>

namespace skyseal::ui {

ProfilePanel::ProfilePanel(QWidget *parent) : DockPanel(parent)
{
    m_pages = new QStackedWidget(this);
    m_empty = new QLabel(m_pages);
    m_empty->setObjectName(QStringLiteral("profileEmpty"));
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_view = new ProfileView(m_pages);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_view);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
    column->addWidget(m_pages);
    showViewState({});
}

void ProfilePanel::showViewState(const ViewState &view)
{
    const auto mission = view.vehicle ? view.vehicle->mission : nullptr;
    if (!mission || mission->empty()) {
        m_mission.reset();
        m_empty->setText(!view.vehicle ? tr("No vehicle. The altitudes of its mission are drawn here once it has been read.")
                             : mission ? tr("The vehicle has no mission. Send a file in the panel Mission to write one.")
                                       : tr("The mission has not been read yet: choose Read from the vehicle in the panel "
                                            "Mission."));
        m_pages->setCurrentWidget(m_empty);
        return;
    }
    const auto &state = view.vehicle->state;
    const auto home = state.home.known() ? std::optional(mercator::project({state.home.latitude, state.home.longitude}))
                                         : std::nullopt;
    const bool sameAltitude = state.home.altitude == m_homeAltitude
        || (std::isnan(state.home.altitude) && std::isnan(m_homeAltitude));
    if (mission == m_mission && home == m_home && sameAltitude && state.missionCurrent == m_current)
        return;
    if (!isExposed())
        return m_mission.reset(); // shown again with the next view
    m_mission = mission;
    m_home = home;
    m_homeAltitude = state.home.altitude;
    m_current = state.missionCurrent;
    const MissionRoute route = routeOf(*mission, home, vehicle::keepsHomeFirst(state.autopilot));
    m_view->showProfile(profileOf(route, m_homeAltitude), m_current);
    m_pages->setCurrentWidget(m_view);
}

void ProfilePanel::applySettings(const Settings &settings)
{
    m_view->setUnits(settings.units);
}

} // namespace skyseal::ui

#include "moc_profile_panel.cpp"
