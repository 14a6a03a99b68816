#include "ui/mission/mission_model.h"

#include "core/mavlink/dialect.h"
#include "core/vehicle/mission_place.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"

#include <QtGui/QFont>

namespace skyseal::ui {

namespace {

QString commandName(std::uint16_t command)
{
    const mavlink::EnumInfo *commands = mavlink::Dialect::builtin().enumeration("MAV_CMD");
    QString name = commands ? fromStd(commands->nameOf(command)) : QString();
    if (name.isEmpty())
        return QString::number(command);
    name.remove(QLatin1String("MAV_CMD_"));
    name.remove(QLatin1String("NAV_"));
    return name;
}

} // namespace

void MissionModel::setMission(const Mission &mission, int current, bool firstIsHome)
{
    if (mission != m_mission || firstIsHome != m_firstIsHome) {
        beginResetModel();
        m_mission = mission;
        m_current = current;
        m_firstIsHome = firstIsHome;
        endResetModel();
    } else if (current != m_current) {
        m_current = current;
        if (rowCount() > 0)
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
    }
}

void MissionModel::setUnits(UnitSystem units)
{
    m_units = units;
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, Altitude), index(rowCount() - 1, Altitude));
}

int MissionModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() || !m_mission ? 0 : static_cast<int>(m_mission->size());
}

int MissionModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant MissionModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const vehicle::MissionItem &item = (*m_mission)[static_cast<std::size_t>(index.row())];
    const bool isCurrent = item.sequence == m_current;
    if (role == Qt::FontRole && isCurrent) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    if (role == Qt::TextAlignmentRole && index.column() != Command)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case Number: return item.sequence;
    case Command: {
        const QString name = m_firstIsHome && item.sequence == 0 ? tr("home") : commandName(item.command);
        return isCurrent ? tr("%1 (now)").arg(name) : name;
    }
    case Latitude: return vehicle::hasPlace(item) ? number(item.latitude, 7) : dash();
    case Longitude: return vehicle::hasPlace(item) ? number(item.longitude, 7) : dash();
    case Altitude: return vehicle::hasAltitude(item) ? altitudeText(item) : dash();
    default: return {};
    }
}

QString MissionModel::altitudeText(const vehicle::MissionItem &item) const
{
    QString altitude = altitudeFigure(static_cast<double>(item.altitude), m_units).text();
    switch (vehicle::altitudeReferenceOf(item.frame)) {
    case vehicle::AltitudeReference::SeaLevel: return tr("%1 MSL").arg(altitude);
    case vehicle::AltitudeReference::Terrain: return tr("%1 above ground").arg(altitude);
    case vehicle::AltitudeReference::Home: break;
    }
    return altitude;
}

QVariant MissionModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Number: return tr("No.");
    case Command: return tr("Command");
    case Latitude: return tr("Latitude");
    case Longitude: return tr("Longitude");
    case Altitude: return tr("Altitude");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_mission_model.cpp"
