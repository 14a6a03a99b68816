#include "ui/vehicles/vehicle_list_model.h"

#include "ui/text/plain_tip.h"
#include "ui/theme/grid.h"
#include "ui/theme/icons.h"
#include "ui/theme/palettes.h"

#include <QtGui/QFont>
#include <QtGui/QGuiApplication>
#include <QtGui/QIcon>
#include <QtGui/QPixmap>

#include <algorithm>
#include <utility>

namespace skyseal::ui {

namespace {

/// A shape before the selected vehicle, and as much room before the others.
QIcon mark(bool selected)
{
    if (selected)
        return icon(QStringLiteral("vehicle"));
    QPixmap room(2 * kGrid, 2 * kGrid);
    room.fill(Qt::transparent);
    return QIcon(room);
}

QVariant toneColor(CellTone tone)
{
    const StateColors &colors = stateColors(QGuiApplication::palette());
    switch (tone) {
    case CellTone::Dim: return colors.dim;
    case CellTone::Warning: return colors.warning;
    case CellTone::Alarm: return colors.alarm;
    case CellTone::Usual: break;
    }
    return {};
}

bool isFigure(int column)
{
    return column == VehicleListRow::Battery || column == VehicleListRow::Link || column == VehicleListRow::LastFrame;
}

} // namespace

void VehicleListModel::setVehicles(std::vector<VehicleListRow> vehicles)
{
    for (int row = rowCount() - 1; row >= 0; --row) {
        const std::uint8_t id = m_rows[static_cast<std::size_t>(row)].systemId;
        if (std::ranges::find(vehicles, id, &VehicleListRow::systemId) != vehicles.end())
            continue;
        beginRemoveRows({}, row, row);
        m_rows.erase(m_rows.begin() + row);
        endRemoveRows();
    }
    for (VehicleListRow &vehicle : vehicles) {
        const int row = rowOf(vehicle.systemId);
        if (row >= 0) {
            renew(row, std::move(vehicle));
            continue;
        }
        beginInsertRows({}, rowCount(), rowCount());
        m_rows.push_back(std::move(vehicle));
        endInsertRows();
    }
}

void VehicleListModel::renew(int row, VehicleListRow vehicle)
{
    VehicleListRow &own = m_rows[static_cast<std::size_t>(row)];
    const VehicleListRow before = std::exchange(own, std::move(vehicle));
    const bool marked = before.selected != own.selected; // in bold, the whole row
    for (int column = 0; column < VehicleListRow::Columns; ++column) {
        const auto at = static_cast<std::size_t>(column);
        if (marked || !own.cells[at].looksAs(before.cells[at]))
            Q_EMIT dataChanged(index(row, column), index(row, column));
    }
}

int VehicleListModel::rowOf(std::uint8_t systemId) const
{
    const auto at = std::ranges::find(m_rows, systemId, &VehicleListRow::systemId);
    return at == m_rows.end() ? -1 : static_cast<int>(at - m_rows.begin());
}

int VehicleListModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int VehicleListModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : VehicleListRow::Columns;
}

QVariant VehicleListModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const VehicleListRow &row = m_rows[static_cast<std::size_t>(index.row())];
    const VehicleListCell &cell = row.cells[static_cast<std::size_t>(index.column())];
    const bool isName = index.column() == VehicleListRow::Vehicle;
    switch (role) {
    case Qt::DisplayRole: return cell.text;
    case Qt::ToolTipRole: return plainTip(cell.tip).replace(QLatin1Char('\n'), QLatin1String("<br>"));
    case Qt::AccessibleTextRole:
        return isName && row.selected ? tr("Vehicle %1, selected").arg(cell.text)
            : isName                  ? tr("Vehicle %1").arg(cell.text)
                                      : QVariant();
    case Qt::DecorationRole: return isName ? mark(row.selected) : cell.icon.isEmpty() ? QVariant() : QVariant(icon(cell.icon));
    case Qt::ForegroundRole: return toneColor(cell.tone);
    case Qt::FontRole: {
        QFont bold;
        bold.setBold(true);
        return row.selected ? QVariant(bold) : QVariant();
    }
    case Qt::TextAlignmentRole: return isFigure(index.column()) ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    case SystemIdRole: return row.systemId;
    case RankRole: return cell.rank;
    default: return {};
    }
}

QVariant VehicleListModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((isFigure(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case VehicleListRow::Vehicle: return tr("Vehicle");
    case VehicleListRow::Kind: return tr("Kind");
    case VehicleListRow::Mode: return tr("Mode");
    case VehicleListRow::Armed: return tr("Armed");
    case VehicleListRow::Battery: return tr("Battery");
    case VehicleListRow::Link: return tr("Link");
    case VehicleListRow::LastFrame: return tr("Last frame");
    case VehicleListRow::Lock: return tr("Lock");
    case VehicleListRow::Alerts: return tr("Alerts");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_vehicle_list_model.cpp"
