// Table model of the station's links: URL, state, local and remote address, traffic. Main thread.
#pragma once

#include "core/engine/common/link_snapshot.h"

#include <QtCore/QAbstractTableModel>

namespace skyseal::ui {

class LinkModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Url, State, Local, Remote, Received, Sent, BadFrames, Columns };

    using QAbstractTableModel::QAbstractTableModel;

    void setLinks(const std::vector<engine::LinkSnapshot> &links);
    const engine::LinkSnapshot *linkAt(int row) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<engine::LinkSnapshot> m_links;
};

} // namespace skyseal::ui
