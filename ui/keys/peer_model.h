// The known peers as a table.
#pragma once

#include "ui/keys/keyring_interface.h"

#include <QtCore/QAbstractTableModel>

namespace skyseal::ui {

class PeerModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Systems, LastSeen, Fingerprint, Columns };

    using QAbstractTableModel::QAbstractTableModel;

    void setPeers(std::vector<KnownPeer> peers);
    const KnownPeer *peerAt(int row) const;
    /// Returns -1 if there is none.
    int rowOf(const QString &name) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(const KnownPeer &peer, int column) const;

    std::vector<KnownPeer> m_peers;
};

} // namespace skyseal::ui
