// Contents of the map for the selected vehicle: vehicle, home, mission and the track. Built from view states. Positions are in
// metres of the projection (see mercator.h).
#pragma once

#include "ui/tiles/mercator.h"
#include "ui/map/mission_route.h"
#include "ui/map/track.h"
#include "ui/view_state.h"

#include <memory>
#include <optional>
#include <vector>

namespace skyseal::ui {

class MapContent
{
public:
    /// The parts that a view state changed visibly.
    struct Changes
    {
        bool ground = false;  ///< home, mission or track
        bool vehicle = false; ///< position, heading or state of the vehicle
        bool moved = false;   ///< position of the vehicle
    };

    /// Takes the vehicle of `view`, and forgets everything of another vehicle shown before. Ignores movements below half a
    /// pixel.
    Changes show(const ViewState &view, double metresPerPixel);
    void clearTrack() { m_track.clear(); }

    const std::optional<QPointF> &vehicle() const { return m_vehicle; }
    const std::optional<QPointF> &home() const { return m_home; }
    double heading() const { return m_heading; } ///< degrees
    bool isStale() const { return m_stale; }
    crypto::SuiteId suite() const { return m_suite; }
    const Track &track() const { return m_track; }
    /// Nothing until the mission was read.
    const std::optional<MissionRoute> &route() const { return m_route; }
    int missionCurrent() const { return m_missionCurrent; }

private:
    bool startOver(std::uint8_t systemId);
    bool isJump(const QPointF &now, double time) const;
    bool showMission(const engine::VehicleSnapshot &vehicle, bool homeMoved);

    std::uint8_t m_systemId = 0;
    std::optional<QPointF> m_vehicle, m_home;
    double m_heading = 0;
    bool m_stale = false;
    crypto::SuiteId m_suite{};
    Track m_track;
    QPointF m_lastKnown;
    double m_positionAt = 0; ///< time of the snapshot with the last position, seconds
    std::shared_ptr<const std::vector<vehicle::MissionItem>> m_mission;
    std::optional<MissionRoute> m_route;
    int m_missionCurrent = -1;
};

} // namespace skyseal::ui
