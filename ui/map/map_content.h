// Contents of the map: the selected vehicle with home, mission and track, and the other vehicles. Built from view states.
// Positions are in metres of the projection (see mercator.h).
#pragma once

#include "ui/tiles/mercator.h"
#include "ui/map/mission_route.h"
#include "ui/map/track.h"
#include "ui/track_colors.h"
#include "ui/map/vehicle_markers.h"
#include "ui/view_state.h"

#include <memory>
#include <optional>
#include <vector>

namespace skyseal::engine {
class FlownTracks;
struct Snapshot;
} // namespace skyseal::engine

namespace skyseal::ui {

class MapContent
{
public:
    /// The parts that a view state changed visibly.
    struct Changes
    {
        bool ground = false;  ///< home, mission or track
        bool vehicle = false; ///< position, heading or state of any vehicle
        bool moved = false;   ///< position of the selected vehicle
    };

    /// Takes the vehicle of `view`, and forgets everything of another vehicle shown before. Ignores movements below half a
    /// pixel.
    Changes show(const ViewState &view, double metresPerPixel);
    void clearTrack() { m_track.clear(); }

    std::uint8_t systemId() const { return m_systemId; }
    const std::optional<QPointF> &vehicle() const { return m_vehicle; }
    const std::optional<QPointF> &home() const { return m_home; }
    double heading() const { return m_heading; } ///< degrees
    bool isStale() const { return m_age > 0; }
    std::optional<crypto::SuiteId> suite() const { return m_suite; } ///< see linkSuiteOf()
    int age() const { return m_age; }                                ///< see staleAge()
    const std::vector<VehicleMarker> &others() const { return m_others; }
    const Track &track() const { return m_track; }
    TrackColors trackColors() const { return m_trackColors; }
    void setTrackColors(TrackColors colors) { m_trackColors = colors; }
    /// Nothing until the mission was read.
    const std::optional<MissionRoute> &route() const { return m_route; }
    /// The vehicle may have another mission by now.
    bool isRouteOutdated() const { return m_isRouteOutdated; }
    int missionCurrent() const { return m_missionCurrent; }

private:
    bool startOver(std::uint8_t systemId);
    bool showFlown(const engine::Snapshot &snapshot, bool another);
    bool isJump(const QPointF &now, double time) const;
    bool showMission(const engine::VehicleSnapshot &vehicle, bool homeMoved);

    std::uint8_t m_systemId = 0;
    std::optional<QPointF> m_vehicle, m_home;
    double m_heading = 0;
    int m_age = 0;
    std::optional<crypto::SuiteId> m_suite;
    std::vector<VehicleMarker> m_others;
    Track m_track;
    TrackColors m_trackColors = TrackColors::Suite;
    QPointF m_lastKnown;
    double m_positionAt = 0;                            ///< time of the snapshot with the last position, seconds
    std::shared_ptr<const engine::FlownTracks> m_flown; ///< of the last seek of a replay
    std::shared_ptr<const std::vector<vehicle::MissionItem>> m_mission;
    std::optional<MissionRoute> m_route;
    bool m_isRouteOutdated = false;
    int m_missionCurrent = -1;
};

} // namespace skyseal::ui
