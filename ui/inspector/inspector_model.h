// The received message types, one row for each sender and type. Rows keep their order: new types are inserted, those of a
// sender that is gone are removed, values change in place.
#pragma once

#include "core/engine/station/inspector_row.h"

#include <QtCore/QAbstractTableModel>

namespace skyseal::ui {

class InspectorModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Id, Sender, Rate, Count, Version, Columns };

    using QAbstractTableModel::QAbstractTableModel;

    /// Shows these rows, sorted by sender and name.
    void setRows(const std::vector<engine::InspectorRow> &rows);
    const engine::InspectorRow *rowAt(int row) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<engine::InspectorRow> m_rows;
};

} // namespace skyseal::ui
