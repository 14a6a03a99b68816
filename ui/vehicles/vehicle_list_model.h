// Table model of all vehicles. A vehicle keeps its row, new ones come last, and only cells that look different are notified, so
// that fifty vehicles cost little. GUI thread.
#pragma once

#include "ui/vehicles/vehicle_list_row.h"

#include <QtCore/QAbstractTableModel>

#include <vector>

namespace skyseal::ui {

class VehicleListModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Role { SystemIdRole = Qt::UserRole, RankRole };

    using QAbstractTableModel::QAbstractTableModel;

    /// Takes the rows of this moment, in any order, each vehicle once.
    void setVehicles(std::vector<VehicleListRow> vehicles);
    /// The row of this vehicle; -1 if it is not in the list.
    int rowOf(std::uint8_t systemId) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void renew(int row, VehicleListRow vehicle);

    std::vector<VehicleListRow> m_rows;
};

} // namespace skyseal::ui
