// The items of a mission as a table.
#pragma once

#include "core/vehicle/mission.h"
#include "ui/text/units.h"

#include <QtCore/QAbstractTableModel>

#include <memory>
#include <vector>

namespace skyseal::ui {

class MissionModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    using Mission = std::shared_ptr<const std::vector<vehicle::MissionItem>>;
    enum Column { Number, Command, Latitude, Longitude, Altitude, Columns };

    using QAbstractTableModel::QAbstractTableModel;

    /// `current` is the item that the vehicle flies to, −1 for none. With `firstIsHome`, item 0 is home and not flown.
    void setMission(const Mission &mission, int current, bool firstIsHome);

    void setUnits(UnitSystem units);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    /// With its reference, unless that is home.
    QString altitudeText(const vehicle::MissionItem &item) const;

    Mission m_mission;
    int m_current = -1;
    bool m_firstIsHome = false;
    UnitSystem m_units = UnitSystem::Metric;
};

} // namespace skyseal::ui
