// The recordings of a folder as a table.
#pragma once

#include "core/engine/replay/recording_info.h"

#include <QtCore/QAbstractTableModel>

#include <vector>

namespace skyseal::ui {

class RecordingModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Date, Vehicle, Length, Ciphers, Size, File, Columns };
    static constexpr int kSortRole = Qt::UserRole; ///< a value in the order of the column

    using QAbstractTableModel::QAbstractTableModel;

    void setRecordings(std::vector<engine::RecordingInfo> recordings);
    /// Replaces the one with the same path.
    void update(const engine::RecordingInfo &recording);
    const engine::RecordingInfo &recording(int row) const { return m_recordings[static_cast<std::size_t>(row)]; }
    /// How many of the recordings were read.
    int readCount() const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::vector<engine::RecordingInfo> m_recordings;
};

} // namespace skyseal::ui
