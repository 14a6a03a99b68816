// The files that are drawn over the map, as an item model: what each shows, and why it does not. A thread reads the files, so
// that the map does not wait for a disk. Lives on the GUI thread.
#pragma once

#include "core/engine/common/file_thread.h"
#include "ui/overlays/overlay_file.h"
#include "ui/overlays/projected_overlay.h"

#include <QtCore/QAbstractTableModel>
#include <QtCore/QDateTime>

#include <memory>
#include <vector>

namespace skyseal::ui {

class OverlayModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { File, Color, Shapes, State, Columns };

    struct Entry
    {
        OverlayFile file;
        std::shared_ptr<const ProjectedOverlay> shapes = {}; ///< null: never read since the start
        std::size_t leftOut = 0;
        QString problem = {}; ///< why it could not be read the last time
        bool isReading = false;
        bool hasChanged = false; ///< it differs from what the operator has accepted
        qint64 size = -1;        ///< when it was read, as is the time
        QDateTime modified = {};
        int id = 0;
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// Shows these files, and reads those that it did not show before.
    void setFiles(const QList<OverlayFile> &files);
    QList<OverlayFile> files() const;
    const std::vector<Entry> &entries() const { return m_entries; }

    /// Adds a file, or reads it again if it is there. False if there are kMostOverlays files.
    bool add(const QString &path);
    void remove(int row);
    void setColor(int row, OverlayColor color);
    /// Reads the file, and accepts it as it is now.
    void readAgain(int row);
    /// Reads those files again that have another time or size.
    void check();
    /// One or more sentences about a file; empty if there is nothing to say.
    QString stateText(int row) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

Q_SIGNALS:
    /// The shapes on the map have changed.
    void pictureChanged();
    /// The operator has changed files().
    void filesChanged();

private:
    enum class Accept { No, Yes };
    struct Reading;

    void append(const OverlayFile &file, Accept accept);
    void read(Entry &entry, Accept accept, bool onlyIfNewer = false);
    void take(int id, Accept accept, const Reading &reading);
    void showRow(std::size_t row);
    OverlayColor freeColor() const;

    std::vector<Entry> m_entries;
    int m_lastId = 0;
    engine::FileThread m_thread;
};

} // namespace skyseal::ui
