#include "app/skyseal/run_marker.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace skyseal::app {

namespace {

constexpr qint64 kLongest = 65536; ///< bytes that are read
const QString kPrefix = QStringLiteral("run-");
const QByteArray kRecording = "recording ", kLink = "link ";

/// Whole lines only: the last one may be cut.
RunRecord parse(const QByteArray &text)
{
    RunRecord out;
    for (const QByteArray &line : text.left(text.lastIndexOf('\n') + 1).split('\n')) {
        if (line.startsWith(kRecording))
            out.recording = QString::fromUtf8(line.mid(kRecording.size()));
        else if (line.startsWith(kLink))
            out.links << QString::fromUtf8(line.mid(kLink.size()));
    }
    return out;
}

QByteArray textOf(const RunRecord &record)
{
    QByteArray out;
    if (!record.recording.isEmpty())
        out += kRecording + record.recording.toUtf8() + '\n';
    for (const QString &link : record.links)
        out += kLink + link.toUtf8() + '\n';
    return out;
}

/// Reads and removes the marker if nobody holds it.
std::optional<RunRecord> takeIfAbandoned(const QString &path)
{
    const QByteArray name = QFile::encodeName(path);
    const int descriptor = open(name.constData(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0)
        return std::nullopt;
    std::optional<RunRecord> out;
    struct stat facts = {};
    // Without a link, another start has taken it meanwhile.
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && fstat(descriptor, &facts) == 0 && facts.st_nlink > 0) {
        QFile file;
        if (file.open(descriptor, QIODevice::ReadOnly)) {
            out = parse(file.read(kLongest));
            out->last = QDateTime::fromSecsSinceEpoch(facts.st_mtime);
        }
        unlink(name.constData());
    }
    close(descriptor);
    return out;
}

} // namespace

RunMarker::RunMarker(QString folder) : m_folder(std::move(folder))
{
    if (!QDir().mkpath(m_folder))
        return;
    // Under another name until it is locked, since it would look abandoned before.
    QByteArray made = QFile::encodeName(m_folder + QStringLiteral("/new-XXXXXX"));
    m_descriptor = mkostemp(made.data(), O_CLOEXEC);
    if (m_descriptor < 0)
        return;
    m_file = m_folder + QLatin1Char('/') + kPrefix + QFile::decodeName(made.right(6));
    if (flock(m_descriptor, LOCK_EX | LOCK_NB) != 0 || rename(made.constData(), QFile::encodeName(m_file).constData()) != 0) {
        unlink(made.constData());
        close(std::exchange(m_descriptor, -1));
    }
}

RunMarker::~RunMarker()
{
    if (m_descriptor < 0)
        return;
    unlink(QFile::encodeName(m_file).constData());
    close(m_descriptor);
}

void RunMarker::update(const RunRecord &record)
{
    if (m_descriptor < 0 || (record.recording == m_stored.recording && record.links == m_stored.links))
        return;
    m_stored = record;
    const QByteArray text = textOf(record);
    if (pwrite(m_descriptor, text.constData(), static_cast<std::size_t>(text.size()), 0) == text.size())
        static_cast<void>(ftruncate(m_descriptor, text.size()) == 0);
}

std::optional<RunRecord> RunMarker::takeUnfinished() const
{
    std::optional<RunRecord> newest;
    for (const QFileInfo &file : QDir(m_folder).entryInfoList({kPrefix + QLatin1Char('*')}, QDir::Files, QDir::Time)) {
        if (file.filePath() == m_file)
            continue;
        const auto found = takeIfAbandoned(file.filePath());
        if (found && !found->isEmpty() && !newest)
            newest = found;
    }
    return newest;
}

} // namespace skyseal::app
