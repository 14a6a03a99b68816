#include "core/engine/replay/recording_folder.h"

#include "core/log/open_log.h"

#include <algorithm>
#include <filesystem>

namespace skyseal::engine {

namespace {

namespace fs = std::filesystem;

WallTime wallTimeOf(fs::file_time_type time)
{
    return std::chrono::floor<WallTime::duration>(std::chrono::file_clock::to_sys(time));
}

} // namespace

std::vector<RecordingInfo> recordingsIn(const std::string &folder)
{
    std::vector<RecordingInfo> out;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code unreadable;
        if (entry->path().extension() != ".tlog" || !entry->is_regular_file(unreadable))
            continue;
        RecordingInfo one{entry->path().string(), entry->path().filename().string()};
        one.bytes = entry->file_size(unreadable);
        one.modified = wallTimeOf(entry->last_write_time(unreadable));
        std::error_code none;
        if (const auto size = fs::file_size(tlog::linkEventsFile(one.path), none); !none)
            one.eventBytes = size;
        if (!unreadable)
            out.push_back(std::move(one));
    }
    std::ranges::sort(out, [](const RecordingInfo &a, const RecordingInfo &b) {
        return a.modified != b.modified ? a.modified > b.modified : a.name > b.name;
    });
    return out;
}

RecordingInfo readRecording(RecordingInfo recording, const std::atomic<bool> &stopped)
{
    constexpr std::size_t kPortion = 10'000;
    auto file = tlog::openLog(recording.path);
    if (!file) {
        recording.problem = file.error();
        return recording;
    }
    tlog::LogIndexer indexer(*file, tlog::linkEventsOf(recording.path));
    indexer.endWhen(stopped);
    while (!stopped) {
        if (!indexer.read(kPortion))
            continue;
        if (stopped)
            break; // what was read is not all of it
        recording.index = std::make_shared<const tlog::LogIndex>(indexer.take());
        break;
    }
    return recording;
}

} // namespace skyseal::engine
