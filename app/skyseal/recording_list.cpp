#include "app/skyseal/recording_list.h"

#include "core/engine/replay/index_cache.h"
#include "core/engine/replay/recording_folder.h"

#include <algorithm>
#include <functional>
#include <set>
#include <string_view>

namespace skyseal::app {

namespace {

using engine::IndexCache;
using engine::RecordingInfo;

/// The folder of a recording, as recordingsIn() writes it.
std::string_view folderOf(const RecordingInfo &recording)
{
    return std::string_view(recording.path).substr(0, recording.path.size() - recording.name.size());
}

} // namespace

RecordingList::~RecordingList()
{
    stop();
}

void RecordingList::list(const std::string &folder)
{
    struct Listing
    {
        std::vector<RecordingInfo> files, cached;
    };
    stop();
    m_stopped = std::make_shared<std::atomic<bool>>(false);
    m_thread.run(
        this,
        [folder, cache = std::exchange(m_toLoad, {})] {
            return Listing{engine::recordingsIn(folder),
                           cache.empty() ? std::vector<RecordingInfo>() : engine::loadIndexes(cache)};
        },
        [this, stopped = m_stopped](Listing listing) {
            for (const RecordingInfo &one : listing.cached)
                m_known.try_emplace(keyOf(one), one);
            if (!*stopped)
                takeFiles(std::move(listing.files));
        });
}

void RecordingList::stop()
{
    if (m_stopped)
        *m_stopped = true;
    m_stopped.reset();
    m_waiting.clear();
    save();
}

void RecordingList::takeFiles(std::vector<RecordingInfo> files)
{
    forgetOlder(files);
    for (RecordingInfo &file : files) {
        if (const auto known = m_known.find(keyOf(file)); known != m_known.end())
            file = known->second;
        else
            m_waiting.push_back(file);
    }
    Q_EMIT listed(std::move(files));
    readNext();
}

/// Forgets what was known of the folder's files and is no longer so: of deleted files, and of those that have changed.
void RecordingList::forgetOlder(const std::vector<RecordingInfo> &files)
{
    if (files.empty())
        return;
    std::set<Key> present;
    for (const RecordingInfo &file : files)
        present.insert(keyOf(file));
    std::erase_if(m_known, [&](const auto &known) {
        return folderOf(known.second) == folderOf(files.front()) && !present.contains(known.first);
    });
}

void RecordingList::readNext()
{
    if (m_waiting.empty()) {
        save();
        return;
    }
    m_thread.run(
        this, [file = m_waiting.front(), stopped = m_stopped] { return engine::readRecording(file, *stopped); },
        [this, stopped = m_stopped](const RecordingInfo &recording) {
            if (*stopped)
                return;
            m_waiting.pop_front();
            keep(recording);
            Q_EMIT read(recording);
            if (!*stopped)
                readNext();
        });
}

void RecordingList::keep(const RecordingInfo &recording)
{
    if (!recording.isRead())
        return;
    if (m_known.size() >= IndexCache::kMostRecordings)
        m_known.erase(std::ranges::min_element(m_known, {}, [](const auto &known) { return known.second.modified; }));
    m_known.insert_or_assign(keyOf(recording), recording);
    m_unsaved = m_unsaved || recording.index;
}

/// The newest first, for the limits of the cache. If it cannot be written, the recordings are read again at the next start.
void RecordingList::save()
{
    if (!std::exchange(m_unsaved, false) || m_cacheFile.empty())
        return;
    std::vector<RecordingInfo> all;
    for (const auto &[key, recording] : m_known)
        all.push_back(recording);
    std::ranges::sort(all, std::greater(), &RecordingInfo::modified);
    m_thread.run(
        this, [file = m_cacheFile, all = std::move(all)] { return engine::saveIndexes(file, all).has_value(); }, [](bool) {});
}

} // namespace skyseal::app

#include "moc_recording_list.cpp"
