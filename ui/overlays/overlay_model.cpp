#include "ui/overlays/overlay_model.h"

#include "core/overlay/overlay_reader.h"
#include "ui/text/plain_tip.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"

#include <QtCore/QFileInfo>
#include <QtGui/QGuiApplication>

#include <algorithm>

namespace skyseal::ui {

struct OverlayModel::Reading
{
    bool isSame = false; ///< the file was not read, since its time and size are the same
    qint64 size = -1;
    QDateTime modified = {};
    std::shared_ptr<const ProjectedOverlay> shapes = {}; ///< null: it could not be read
    std::size_t leftOut = 0;
    QByteArray digest = {};
    QString problem = {};
};

void OverlayModel::setFiles(const QList<OverlayFile> &wanted)
{
    if (wanted == files())
        return;
    beginResetModel();
    m_entries.clear();
    endResetModel();
    for (const OverlayFile &file : wanted)
        append(file, Accept::No);
    Q_EMIT pictureChanged();
}

QList<OverlayFile> OverlayModel::files() const
{
    QList<OverlayFile> out;
    for (const Entry &entry : m_entries)
        out << entry.file;
    return out;
}

bool OverlayModel::add(const QString &path)
{
    const auto found = std::ranges::find(m_entries, path, [](const Entry &entry) { return entry.file.path; });
    if (found != m_entries.end()) {
        readAgain(static_cast<int>(found - m_entries.begin()));
        return true;
    }
    if (m_entries.size() >= kMostOverlays)
        return false;
    append({.path = path, .color = freeColor()}, Accept::Yes);
    Q_EMIT filesChanged();
    return true;
}

/// The first one that no file has yet.
OverlayColor OverlayModel::freeColor() const
{
    for (int i = 0; i < kOverlayColors; ++i) {
        const auto color = static_cast<OverlayColor>(i);
        if (std::ranges::none_of(m_entries, [color](const Entry &entry) { return entry.file.color == color; }))
            return color;
    }
    return OverlayColor::Blue;
}

void OverlayModel::append(const OverlayFile &file, Accept accept)
{
    const int row = rowCount();
    beginInsertRows({}, row, row);
    m_entries.push_back({.file = file, .id = ++m_lastId});
    endInsertRows();
    read(m_entries.back(), accept);
}

void OverlayModel::remove(int row)
{
    beginRemoveRows({}, row, row);
    m_entries.erase(m_entries.begin() + row);
    endRemoveRows();
    Q_EMIT filesChanged();
    Q_EMIT pictureChanged();
}

void OverlayModel::setColor(int row, OverlayColor color)
{
    OverlayFile &file = m_entries[static_cast<std::size_t>(row)].file;
    if (file.color == color)
        return;
    file.color = color;
    showRow(static_cast<std::size_t>(row));
    Q_EMIT filesChanged();
    Q_EMIT pictureChanged();
}

void OverlayModel::readAgain(int row)
{
    read(m_entries[static_cast<std::size_t>(row)], Accept::Yes);
    showRow(static_cast<std::size_t>(row));
}

void OverlayModel::check()
{
    for (Entry &entry : m_entries)
        if (!entry.isReading)
            read(entry, Accept::No, true);
}

void OverlayModel::read(Entry &entry, Accept accept, bool onlyIfNewer)
{
    entry.isReading = !onlyIfNewer; // of a look at the time nobody is told
    const auto work = [path = entry.file.path, size = entry.size, modified = entry.modified, onlyIfNewer] {
        const QFileInfo info(path);
        Reading out{.size = info.size(), .modified = info.lastModified()};
        if (onlyIfNewer && size == out.size && modified == out.modified) {
            out.isSame = true;
            return out;
        }
        if (auto read = overlay::readOverlay(path)) {
            out.shapes = std::make_shared<const ProjectedOverlay>(projectOverlay(read->overlay));
            out.leftOut = read->overlay.leftOut;
            out.digest = read->digest;
        } else {
            out.problem = reasonText(read.error().reason());
        }
        return out;
    };
    m_thread.run(this, work, [this, id = entry.id, accept](const Reading &reading) { take(id, accept, reading); });
}

void OverlayModel::take(int id, Accept accept, const Reading &reading)
{
    const auto found = std::ranges::find(m_entries, id, &Entry::id);
    if (found == m_entries.end() || reading.isSame)
        return;
    found->isReading = false;
    found->size = reading.size;
    found->modified = reading.modified;
    found->problem = reading.problem;
    if (reading.shapes) {
        found->shapes = reading.shapes;
        found->leftOut = reading.leftOut;
        if (accept == Accept::Yes || found->file.digest.isEmpty()) {
            found->file.digest = reading.digest;
            Q_EMIT filesChanged();
        }
        found->hasChanged = found->file.digest != reading.digest;
    }
    showRow(static_cast<std::size_t>(found - m_entries.begin()));
    Q_EMIT pictureChanged();
}

void OverlayModel::showRow(std::size_t row)
{
    const int number = static_cast<int>(row);
    Q_EMIT dataChanged(index(number, 0), index(number, Columns - 1));
}

QString OverlayModel::stateText(int row) const
{
    const Entry &entry = m_entries[static_cast<std::size_t>(row)];
    if (entry.isReading)
        return tr("Reading…");
    QStringList out;
    if (!entry.problem.isEmpty())
        out << (entry.shapes ? tr("Shown as last read: %1").arg(entry.problem) : tr("Not shown: %1").arg(entry.problem));
    if (entry.hasChanged)
        out << tr("Changed since it was added");
    if (entry.shapes && entry.leftOut > 0)
        out << tr("%1 not drawn: no position, or an unsupported kind").arg(entry.leftOut);
    return out.join(QStringLiteral(". "));
}

int OverlayModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

int OverlayModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant OverlayModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Entry &entry = m_entries[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        switch (index.column()) {
        case File: return engine::qt(QFileInfo(entry.file.path).fileName().toStdString());
        case Color: return overlayColorText(entry.file.color);
        case Shapes: return entry.shapes ? grouped(entry.shapes->size()) : QStringLiteral("–");
        case State: return stateText(index.row());
        default: return {};
        }
    case Qt::CheckStateRole:
        return index.column() == File ? QVariant(entry.file.visible ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::DecorationRole:
        return index.column() == Color ? QVariant(overlayColor(entry.file.color, QGuiApplication::palette())) : QVariant();
    case Qt::ToolTipRole:
        return plainTip(index.column() == State ? stateText(index.row()) : engine::qt(entry.file.path.toStdString()));
    case Qt::TextAlignmentRole: return index.column() == Shapes ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    default: return {};
    }
}

bool OverlayModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || index.column() != File || role != Qt::CheckStateRole)
        return false;
    m_entries[static_cast<std::size_t>(index.row())].file.visible = value.toInt() == Qt::Checked;
    showRow(static_cast<std::size_t>(index.row()));
    Q_EMIT filesChanged();
    Q_EMIT pictureChanged();
    return true;
}

Qt::ItemFlags OverlayModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
    return index.column() == File ? usual | Qt::ItemIsUserCheckable : usual;
}

QVariant OverlayModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole && section == Shapes)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case File: return tr("File");
    case Color: return tr("Colour");
    case Shapes: return tr("Shapes");
    case State: return tr("State");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_overlay_model.cpp"
