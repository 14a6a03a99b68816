// A small file that exists while this program runs: its recording and its links. An orderly end removes it, so that the next
// start finds what a crash has left behind. The file is locked while its program lives: two instances never take each other
// for dead, and the number of a process that is given again cannot mislead. Lives on the GUI thread; the file is a few lines
// long and is written only when they change.
#pragma once

#include <QtCore/QDateTime>
#include <QtCore/QString>
#include <QtCore/QStringList>

#include <optional>

namespace skyseal::app {

struct RunRecord
{
    QString recording; ///< path of the newest .tlog; empty: none
    QStringList links; ///< URLs
    QDateTime last;    ///< when it was written, as the next start sees it

    bool isEmpty() const { return recording.isEmpty() && links.isEmpty(); }
};

class RunMarker
{
public:
    /// Makes a file in `folder`, which is created. If that fails, nothing is marked: the program runs all the same.
    explicit RunMarker(QString folder);
    /// The orderly end.
    ~RunMarker();
    RunMarker(const RunMarker &) = delete;
    RunMarker &operator=(const RunMarker &) = delete;

    /// Stores what a rescue needs, if it has changed.
    void update(const RunRecord &record);
    /// Record of the newest run that did not end properly; nullopt without one. Removes the files of all of them, so that
    /// each is reported once.
    std::optional<RunRecord> takeUnfinished() const;

private:
    QString m_folder, m_file;
    int m_descriptor = -1;
    RunRecord m_stored;
};

} // namespace skyseal::app
