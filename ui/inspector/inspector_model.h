// The kinds of messages that come in, one row for each sender and kind. Rows keep their place: new kinds are inserted,
// numbers change in place, nothing jumps.
#pragma once

#include "core/engine/station/snapshot.h"

#include <QtCore/QAbstractTableModel>

namespace skyseal::ui {

class InspectorModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Id, Sender, Rate, Count, Version, Columns };

    using QAbstractTableModel::QAbstractTableModel;

    /// Sorted by sender and name by the model itself. An empty list (nobody was watching) keeps what is shown.
    void setRows(const std::vector<engine::InspectorRow> &rows);
    void clear();
    const engine::InspectorRow *rowAt(int row) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<engine::InspectorRow> m_rows;
};

} // namespace skyseal::ui
