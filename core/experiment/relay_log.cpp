#include "core/experiment/relay_log.h"

#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

namespace skyseal::experiment {

namespace {

/// The newest line of a drop in a direction; empty without one.
QJsonObject newestDrop(const QByteArray &lines, const char *direction)
{
    const QByteArray wanted = QByteArray(R"("direction":")") + direction + '"';
    for (qsizetype at = lines.lastIndexOf(wanted); at >= 0; at = at > 0 ? lines.lastIndexOf(wanted, at - 1) : -1) {
        const qsizetype begin = lines.lastIndexOf('\n', at) + 1, end = lines.indexOf('\n', at);
        QJsonObject line = QJsonDocument::fromJson(lines.mid(begin, end - begin)).object();
        if (line[QLatin1String("event")] == QLatin1String("drop"))
            return line;
    }
    return {};
}

void takeSums(const QJsonObject &drop, Counted::Dropped &sums)
{
    if (drop.isEmpty())
        return;
    const QJsonValue soFar = drop[QLatin1String("so_far")];
    const auto count = [&](const char *what) { return static_cast<std::uint64_t>(soFar[QLatin1String(what)].toInteger()); };
    sums = {count("datagrams"), count("records"), count("frames")};
}

} // namespace

void RelayLog::begin()
{
    QFile::remove(m_file);
    m_seen = 0;
    m_dropped = {};
}

const Counted::Relay &RelayLog::read()
{
    QFile file(m_file);
    if (!file.open(QIODevice::ReadWrite | QIODevice::ExistingOnly) || !file.seek(m_seen))
        return m_dropped;
    const QByteArray added = file.readAll();
    const QByteArray lines = added.left(added.lastIndexOf('\n') + 1); // a line that is being written comes next time
    note(lines);
    m_seen += lines.size();
    if (m_seen >= kMostBytes && file.resize(0))
        m_seen = 0;
    return m_dropped;
}

void RelayLog::note(const QByteArray &lines)
{
    takeSums(newestDrop(lines, "forward"), m_dropped.toStation);
    takeSums(newestDrop(lines, "backward"), m_dropped.toAgent);
}

} // namespace skyseal::experiment
