#include "ui/keys/peer_model.h"

#include "core/keys/peers_file.h"
#include "ui/keys/fingerprint_text.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QLocale>
#include <QtCore/QSize>
#include <QtGui/QFontDatabase>
#include <QtGui/QFontMetrics>
#include <QtGui/QGuiApplication>

#include <algorithm>

namespace skyseal::ui {

void PeerModel::setPeers(std::vector<KnownPeer> peers)
{
    const bool same = std::ranges::equal(peers, m_peers, {}, &KnownPeer::name, &KnownPeer::name);
    if (same) { // keeps the selection
        m_peers = std::move(peers);
        if (!m_peers.empty())
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
        return;
    }
    beginResetModel();
    m_peers = std::move(peers);
    endResetModel();
}

const KnownPeer *PeerModel::peerAt(int row) const
{
    return row >= 0 && row < rowCount() ? &m_peers[static_cast<std::size_t>(row)] : nullptr;
}

int PeerModel::rowOf(const QString &name) const
{
    const auto found = std::ranges::find(m_peers, name, &KnownPeer::name);
    return found == m_peers.end() ? -1 : static_cast<int>(found - m_peers.begin());
}

int PeerModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_peers.size());
}

int PeerModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QString PeerModel::text(const KnownPeer &peer, int column) const
{
    switch (column) {
    case Name: return peer.hasPresharedKey ? tr("%1\nwith a pre-shared key").arg(peer.name) : peer.name;
    case Systems: return peer.systems.empty() ? tr("any") : fromStd(keys::systemIdsText(peer.systems));
    case LastSeen:
        if (peer.connected)
            return tr("connected");
        return peer.lastSeen.isNull() ? dash() : QLocale().toString(peer.lastSeen, QLocale::ShortFormat);
    case Fingerprint: return fingerprintLines(peer.key);
    default: return {};
    }
}

QVariant PeerModel::data(const QModelIndex &index, int role) const
{
    const KnownPeer *peer = index.isValid() ? peerAt(index.row()) : nullptr;
    if (!peer)
        return {};
    switch (role) {
    case Qt::DisplayRole: return text(*peer, index.column());
    case Qt::AccessibleTextRole: return text(*peer, index.column()).replace(QLatin1Char('\n'), QLatin1Char(' '));
    case Qt::FontRole:
        return index.column() == Fingerprint ? QVariant(QFontDatabase::systemFont(QFontDatabase::FixedFont)) : QVariant();
    case Qt::SizeHintRole: return QSize(0, 2 * QFontMetrics(QGuiApplication::font()).lineSpacing() + kGrid);
    case Qt::ForegroundRole:
        return index.column() == LastSeen && peer->connected ? QVariant(stateColors(QGuiApplication::palette()).good)
                                                             : QVariant();
    default: return {};
    }
}

QVariant PeerModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name: return tr("Name");
    case Systems: return tr("Systems");
    case LastSeen: return tr("Last seen");
    case Fingerprint: return tr("Fingerprint");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_peer_model.cpp"
