#include "app/skyseal/recording_list.h"

#include "core/engine/replay/recording_folder.h"

namespace skyseal::app {

namespace {

constexpr std::size_t kMostKept = 2000;

} // namespace

void RecordingList::list(const std::string &folder)
{
    stop();
    m_stopped = std::make_shared<std::atomic<bool>>(false);
    m_thread.run(
        this, [folder] { return engine::recordingsIn(folder); },
        [this, stopped = m_stopped](std::vector<engine::RecordingInfo> files) {
            if (!*stopped)
                takeFiles(std::move(files));
        });
}

void RecordingList::stop()
{
    if (m_stopped)
        *m_stopped = true;
    m_stopped.reset();
    m_waiting.clear();
}

void RecordingList::takeFiles(std::vector<engine::RecordingInfo> files)
{
    for (engine::RecordingInfo &file : files) {
        if (const auto known = m_known.find(keyOf(file)); known != m_known.end())
            file = known->second;
        else
            m_waiting.push_back(file);
    }
    Q_EMIT listed(std::move(files));
    readNext();
}

void RecordingList::readNext()
{
    if (m_waiting.empty())
        return;
    m_thread.run(
        this, [file = m_waiting.front(), stopped = m_stopped] { return engine::readRecording(file, *stopped); },
        [this, stopped = m_stopped](const engine::RecordingInfo &recording) {
            if (*stopped)
                return;
            m_waiting.pop_front();
            keep(recording);
            Q_EMIT read(recording);
            if (!*stopped)
                readNext();
        });
}

void RecordingList::keep(const engine::RecordingInfo &recording)
{
    if (m_known.size() >= kMostKept)
        m_known.clear();
    if (recording.isRead())
        m_known.insert_or_assign(keyOf(recording), recording);
}

} // namespace skyseal::app
