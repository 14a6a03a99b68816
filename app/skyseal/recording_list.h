// Lists the recordings of a folder for the window: first their names, then what each contains, the newest first. A thread for
// files reads them, one after the other; the result for a file is kept while its size and time stay the same, in a cache also
// over the starts of the program. Lives on the GUI thread.
#pragma once

#include "core/engine/common/file_thread.h"
#include "core/engine/replay/recording_info.h"

#include <QtCore/QObject>

#include <atomic>
#include <deque>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace skyseal::app {

class RecordingList : public QObject
{
    Q_OBJECT

public:
    /// `cacheFile`: see index_cache.h; empty: nothing is kept over the starts. Read by the first listing, written after each
    /// that has read something new.
    explicit RecordingList(std::string cacheFile = {}, QObject *parent = nullptr)
        : QObject(parent), m_cacheFile(std::move(cacheFile)), m_toLoad(m_cacheFile)
    {}
    ~RecordingList() override;

    /// Ends an earlier listing.
    void list(const std::string &folder);
    void stop();

Q_SIGNALS:
    void listed(std::vector<skyseal::engine::RecordingInfo> recordings);
    /// One of those that were listed, once it was read.
    void read(skyseal::engine::RecordingInfo recording);

private:
    using Key = std::tuple<std::string, std::uint64_t, std::uint64_t, WallTime>;

    void takeFiles(std::vector<engine::RecordingInfo> files);
    void forgetOlder(const std::vector<engine::RecordingInfo> &files);
    void readNext();
    void keep(const engine::RecordingInfo &recording);
    void save();
    static Key keyOf(const engine::RecordingInfo &recording)
    {
        return {recording.path, recording.bytes, recording.eventBytes, recording.modified};
    }

    const std::string m_cacheFile;
    std::string m_toLoad; ///< the cache, until it is read
    bool m_unsaved = false;
    std::map<Key, engine::RecordingInfo> m_known;
    std::deque<engine::RecordingInfo> m_waiting;
    std::shared_ptr<std::atomic<bool>> m_stopped; ///< of the listing that runs; null without one
    engine::FileThread m_thread;
};

} // namespace skyseal::app
