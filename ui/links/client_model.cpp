#include "ui/links/client_model.h"

#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"

#include <algorithm>

namespace skyseal::ui {

void ClientModel::setClients(const std::vector<engine::ClientSnapshot> &clients)
{
    if (std::ranges::equal(clients, m_clients, {}, &engine::ClientSnapshot::address, &engine::ClientSnapshot::address)) {
        m_clients = clients;
        if (!clients.empty())
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
        return;
    }
    beginResetModel();
    m_clients = clients;
    endResetModel();
}

int ClientModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_clients.size());
}

int ClientModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant ClientModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const engine::ClientSnapshot &client = m_clients[static_cast<std::size_t>(index.row())];
    const engine::ClientCounters &counters = client.counters;
    switch (role) {
    case Qt::DisplayRole:
        switch (index.column()) {
        case Client: return fromStd(client.address);
        case Rights:
            // Classes as the address names them.
            return client.write == "none" ? tr("reads")
                : client.write == "all"   ? tr("reads and writes")
                                          : tr("reads, writes %1").arg(fromStd(client.write));
        case Forwarded: return grouped(counters.forwarded);
        case Refused: return grouped(counters.denied + counters.tooOften + counters.notItsSystem);
        default: return {};
        }
    case Qt::ToolTipRole:
        return index.column() == Refused
            ? tr("%1 not permitted, %2 over the rate limit, %3 with a system ID that it may not use")
                  .arg(grouped(counters.denied), grouped(counters.tooOften), grouped(counters.notItsSystem))
            : QVariant();
    case Qt::TextAlignmentRole:
        return index.column() >= Forwarded ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    default: return {};
    }
}

QVariant ClientModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole && section >= Forwarded)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Client: return tr("Station");
    case Rights: return tr("Rights");
    case Forwarded: return tr("Forwarded");
    case Refused: return tr("Refused");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_client_model.cpp"
