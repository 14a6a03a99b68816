#include "ui/replay/recording_model.h"

#include "core/engine/text/state_text.h"
#include "ui/replay/link_event_text.h"
#include "ui/text/plain_tip.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QDateTime>
#include <QtCore/QLocale>

#include <algorithm>

namespace skyseal::ui {

using engine::RecordingInfo;

namespace {

/// The beginning of the flight; without times in the file when it was written.
QDateTime dateOf(const RecordingInfo &recording)
{
    const WallTime time = recording.index && recording.index->first ? *recording.index->first : recording.modified;
    return QDateTime::fromSecsSinceEpoch(std::chrono::floor<std::chrono::seconds>(time.time_since_epoch()).count());
}

QString vehicleOf(const RecordingInfo &recording)
{
    if (!recording.isRead())
        return RecordingModel::tr("reading…");
    if (!recording.index)
        return RecordingModel::tr("cannot be read: %1").arg(reasonText(recording.problem));
    QStringList out;
    for (const std::uint8_t systemId : recording.index->vehicles) {
        const auto mode = std::ranges::find(recording.index->modes, systemId, &tlog::ModeChange::systemId);
        const QString number = QString::number(systemId);
        out << (mode == recording.index->modes.end()
                    ? number
                    : RecordingModel::tr("%1 %2").arg(engine::vehicleTypeText(mode->type), number));
    }
    return out.isEmpty() ? RecordingModel::tr("no vehicle") : out.join(QStringLiteral(", "));
}

/// Each suite once, in the order of their use, and plain MAVLink among them.
QString ciphersOf(const RecordingInfo &recording)
{
    constexpr qsizetype kMostNamed = 8;
    if (!recording.index)
        return {};
    QStringList out;
    for (const tlog::SuiteMark &mark : recording.index->suites) {
        const bool isPlain = mark.event.kind == tlog::LinkEvent::Kind::Plain;
        const QString name = isPlain ? RecordingModel::tr("plain MAVLink") : suiteNameOf(mark.event.suite);
        if (out.contains(name))
            continue;
        if (out.size() == kMostNamed) {
            out << RecordingModel::tr("and others");
            break;
        }
        out << name;
    }
    if (recording.index->unreadableEvents > 0)
        out << unreadableEventsText(*recording.index);
    return out.isEmpty() ? dash() : out.join(QStringLiteral(", "));
}

} // namespace

void RecordingModel::setRecordings(std::vector<RecordingInfo> recordings)
{
    beginResetModel();
    m_recordings = std::move(recordings);
    endResetModel();
}

void RecordingModel::update(const RecordingInfo &recording)
{
    const auto found = std::ranges::find(m_recordings, recording.path, &RecordingInfo::path);
    if (found == m_recordings.end())
        return;
    *found = recording;
    const int row = static_cast<int>(found - m_recordings.begin());
    Q_EMIT dataChanged(index(row, 0), index(row, Columns - 1));
}

int RecordingModel::readCount() const
{
    return static_cast<int>(std::ranges::count_if(m_recordings, &RecordingInfo::isRead));
}

int RecordingModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_recordings.size());
}

int RecordingModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant RecordingModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const RecordingInfo &one = recording(index.row());
    const bool isNumber = index.column() == Length || index.column() == Size;
    if (role == Qt::TextAlignmentRole && isNumber)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && index.column() == Ciphers)
        return plainTip(one.index && one.index->suites.empty() ? tr("No cipher suite is noted beside this recording")
                                                               : ciphersOf(one));
    if (role == Qt::ToolTipRole)
        return plainTip(fromStd(one.path));
    if (role != Qt::DisplayRole && role != kSortRole)
        return {};
    const bool sorts = role == kSortRole;
    switch (index.column()) {
    case Date: {
        const QDateTime date = dateOf(one);
        return sorts ? QVariant(date) : QLocale().toString(date, QStringLiteral("yyyy-MM-dd HH:mm"));
    }
    case Vehicle: return vehicleOf(one);
    case Length: {
        const double length = one.index ? seconds(one.index->length) : -1;
        return sorts ? QVariant(length) : durationText(length);
    }
    case Ciphers: return ciphersOf(one);
    case Size: return sorts ? QVariant(static_cast<qulonglong>(one.bytes)) : sizeText(one.bytes);
    case File: return fromStd(one.name);
    default: return {};
    }
}

QVariant RecordingModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Date: return tr("Date");
    case Vehicle: return tr("Vehicle");
    case Length: return tr("Length");
    case Ciphers: return tr("Ciphers");
    case Size: return tr("Size");
    case File: return tr("File");
    default: return {};
    }
}

} // namespace skyseal::ui

#include "moc_recording_model.cpp"
