// Replays a .tlog recording: one block per frame, at the recorded pace or faster (LinkOptions::replayFactor), but waiting no
// longer than tlog::LogTime::kLongestWait for the next one: a clock that was set is no pause. Blocks that are sent are dropped
// and counted. A file without any frame fails at its end.
#pragma once

#include "core/link/link.h"
#include "core/log/log_reader.h"
#include "core/log/log_time.h"

#include <QtCore/QTimer>

#include <fstream>
#include <memory>

namespace skyseal::link {

class TlogLink final : public Link
{
    Q_OBJECT

public:
    TlogLink(LinkUrl url, LinkId id, LinkListener &listener, LinkOptions options);
    ~TlogLink() override;

    /// Starts from the beginning, also after Ended.
    void open() override;
    void close() override;
    void send(const Address &, ByteView) override { ++m_counters.txDropped; }
    void flush() override {}

private:
    struct Frames;

    void play();
    bool readNext();
    TimePoint due() const;

    std::ifstream m_file;
    std::unique_ptr<tlog::LogReader> m_reader;
    std::unique_ptr<Frames> m_frames;
    QTimer m_timer;
    TimePoint m_startedAt{};
    tlog::LogTime m_line;
    Duration m_nextAt{}; ///< of the frame that was read ahead, since the beginning of the replay as recorded
    bool m_hasFrame = false;
};

} // namespace skyseal::link
