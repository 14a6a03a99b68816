#include "ui/links/link_model.h"

#include "core/engine/text/state_text.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/palettes.h"

#include <QtGui/QGuiApplication>

#include <algorithm>

namespace skyseal::ui {

void LinkModel::setLinks(const std::vector<engine::LinkSnapshot> &links)
{
    const bool same = std::ranges::equal(links, m_links, {}, &engine::LinkSnapshot::id, &engine::LinkSnapshot::id);
    if (same) {
        m_links = links;
        if (!links.empty())
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
        return;
    }
    beginResetModel();
    m_links = links;
    endResetModel();
}

const engine::LinkSnapshot *LinkModel::linkAt(int row) const
{
    return row >= 0 && row < rowCount() ? &m_links[static_cast<std::size_t>(row)] : nullptr;
}

int LinkModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_links.size());
}

int LinkModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant LinkModel::data(const QModelIndex &index, int role) const
{
    const engine::LinkSnapshot *link = index.isValid() ? linkAt(index.row()) : nullptr;
    if (!link)
        return {};
    switch (role) {
    case Qt::DisplayRole:
        switch (index.column()) {
        case Url:
            return link->listenOnly ? tr("%1 · MAVSec 2019, INSECURE, receive only").arg(fromStd(link->url))
                                    : fromStd(link->url);
        case State:
            return link->problem.empty() ? engine::linkPhaseText(link->phase)
                                         : tr("%1: %2").arg(engine::linkPhaseText(link->phase), reasonText(link->problem));
        case Local: return link->localAddress.empty() ? dash() : fromStd(link->localAddress);
        case Remote: return link->remoteAddress.empty() ? dash() : fromStd(link->remoteAddress);
        case Received: return tr("%1 · %2").arg(rateText(link->rxBytesPerSecond), sizeText(link->rxBytes));
        case Sent: return tr("%1 · %2").arg(rateText(link->txBytesPerSecond), sizeText(link->txBytes));
        case BadFrames: return grouped(link->badCrc);
        default: return {};
        }
    case Qt::TextAlignmentRole:
        return index.column() >= Received ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    case Qt::ForegroundRole:
        return index.column() == State && !link->problem.empty() ? QVariant(stateColors(QGuiApplication::palette()).alarm)
                                                                 : QVariant();
    default: return {};
    }
}

QVariant LinkModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole && section >= Received)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Url: return tr("Link");
    case State: return tr("State");
    case Local: return tr("Local");
    case Remote: return tr("Remote");
    case Received: return tr("Received");
    case Sent: return tr("Sent");
    case BadFrames: return tr("Bad frames");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_link_model.cpp"
