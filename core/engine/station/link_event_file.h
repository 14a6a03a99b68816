// Writes the file with the link events beside a recording, see core/log/link_events.h. Bounded, whatever the peers do. Used by
// the writer thread of the recorder.
#pragma once

#include "core/engine/station/recording_file.h"
#include "core/log/link_events.h"

#include <vector>

namespace skyseal::engine {

class LinkEventFile
{
public:
    /// Begins the file of another recording, with the suites that are in use; it is created by its first event.
    void begin(const std::string &recording);
    /// Takes events in their order, and writes them if there is a recording. Returns false, with the reason in errno, if the
    /// file cannot be written: then the rest of the recording has none.
    bool add(const std::vector<tlog::LinkEvent> &events);
    void sync() { m_file.sync(); }
    /// The recording has ended.
    void end();
    const std::string &name() const { return m_file.name(); }

private:
    /// Peers whose suite is remembered for the next recording.
    static constexpr std::size_t kMostPeers = 256;

    bool write(const tlog::LinkEvent &event);
    void remember(const tlog::LinkEvent &event);

    RecordingFile m_file;
    std::string m_recording;              ///< empty while there is none
    std::size_t m_lines = 0;              ///< in the file
    std::vector<tlog::LinkEvent> m_inUse; ///< the newest event of each peer
    bool m_begins = false;                ///< those in use are to be written
};

} // namespace skyseal::engine
