// Table model of the gateway's clients: address, rights, frames forwarded and refused. Main thread.
#pragma once

#include "core/engine/gateway/client_snapshot.h"

#include <QtCore/QAbstractTableModel>

#include <vector>

namespace skyseal::ui {

class ClientModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Client, Rights, Forwarded, Refused, Columns };

    using QAbstractTableModel::QAbstractTableModel;

    void setClients(const std::vector<engine::ClientSnapshot> &clients);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<engine::ClientSnapshot> m_clients;
};

} // namespace skyseal::ui
