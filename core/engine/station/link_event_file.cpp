#include "core/engine/station/link_event_file.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <unistd.h>

namespace skyseal::engine {

namespace {

constexpr std::string_view kHead = "# Cipher suites of this recording: microseconds since 1970 UTC, event, suite, peer\n";

} // namespace

void LinkEventFile::begin(const std::string &recording)
{
    end();
    m_recording = recording;
    m_begins = true;
}

void LinkEventFile::end()
{
    m_file.close();
    m_recording.clear();
    m_lines = 0;
}

bool LinkEventFile::add(const std::vector<tlog::LinkEvent> &events)
{
    bool written = true;
    if (!m_recording.empty() && std::exchange(m_begins, false)) {
        for (tlog::LinkEvent event : m_inUse) {
            event.kind = tlog::LinkEvent::Kind::Sealed;
            written = written && write(event);
        }
    }
    for (const tlog::LinkEvent &event : events) {
        written = written && write(event);
        remember(event);
    }
    return written;
}

bool LinkEventFile::write(const tlog::LinkEvent &event)
{
    if (m_recording.empty() || m_lines == tlog::LinkEvents::kMost)
        return true;
    bool done = m_file.isOpen();
    if (!done) {
        const std::string name = tlog::linkEventsFile(m_recording);
        ::unlink(name.c_str()); // of a recording that was deleted: that of today was created a moment ago
        done = m_file.create(name) && m_file.append(asBytes(kHead));
    }
    if (done && m_file.append(asBytes(tlog::lineOf(event)))) {
        ++m_lines;
        return true;
    }
    const int why = errno;
    m_file.closeAfterError();
    m_recording.clear();
    errno = why;
    return false;
}

/// A vehicle in clear may have been sealed by the time of the next recording, under the name of its peer.
void LinkEventFile::remember(const tlog::LinkEvent &event)
{
    if (event.kind == tlog::LinkEvent::Kind::Plain)
        return;
    const auto known = std::ranges::find(m_inUse, event.peer, &tlog::LinkEvent::peer);
    if (known != m_inUse.end())
        *known = event;
    else if (m_inUse.size() < kMostPeers)
        m_inUse.push_back(event);
}

} // namespace skyseal::engine
