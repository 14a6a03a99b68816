// Reads the plans of a vehicle one after another, since the mission protocol has one transfer at a time: the mission, then the
// fence and the rally points if the vehicle says that it has such lists. Lives on the GUI thread.
#pragma once

#include "core/vehicle/mission.h"
#include "ui/station_interface.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QStringList>

#include <deque>

namespace skyseal::ui {

class PlanReader
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::PlanReader)

public:
    /// `station` must outlive this.
    explicit PlanReader(StationInterface &station) : m_station(station) {}

    /// Begins with the mission. `capabilities`: MAV_PROTOCOL_CAPABILITY of the vehicle, 0 while they are not known. Does
    /// nothing while it reads.
    void read(std::uint8_t systemId, std::uint64_t capabilities);
    void forget() { m_pending.clear(); }
    bool isReading() const { return !m_pending.empty(); }
    /// Returns true if `result` was that of its own request. Then text() is new, and the next list is requested unless a
    /// mission could not be read, as on a link that is down.
    bool handleResult(const vehicle::MissionResult &result);
    /// For people: the list that is being read, or the results.
    const QString &text() const { return m_text; }

private:
    void requestNext();

    StationInterface &m_station;
    std::uint8_t m_systemId = 0;
    std::deque<vehicle::MissionType> m_pending; ///< the first one is requested
    vehicle::RequestId m_request{};
    QStringList m_read, m_failures;
    QString m_text;
};

} // namespace skyseal::ui
