// How long the window's thread is busy: the frames of the window in wall time.
#pragma once

#include <QtCore/QElapsedTimer>
#include <QtCore/QEvent>
#include <QtWidgets/QApplication>

#include <algorithm>
#include <numeric>
#include <vector>

namespace skyseal::test {

/// An application that times its events. A frame lasts from the event that begins a busy stretch, or from the end of the
/// frame before in it, until a top-level window has painted: no update is requested earlier and painted later. A stretch ends
/// when the thread has nothing to do for 0.2 ms.
class MeteredApplication : public QApplication
{
public:
    MeteredApplication(int &argc, char **argv) : QApplication(argc, argv) { m_clock.start(); }

    bool notify(QObject *receiver, QEvent *event) override
    {
        if (m_depth > 0)
            return QApplication::notify(receiver, event);
        const qint64 begin = m_clock.nsecsElapsed();
        if (begin - m_end > kIdle) {
            m_stretch = begin;
            m_frame = begin;
        }
        const bool paints = event->type() == QEvent::UpdateRequest && receiver->isWidgetType();
        ++m_depth;
        const bool done = QApplication::notify(receiver, event); // may delete the receiver
        --m_depth;
        m_end = m_clock.nsecsElapsed();
        m_worstStretch = std::max(m_worstStretch, m_end - m_stretch);
        if (paints) {
            m_frames.push_back(m_end - m_frame);
            m_frame = m_end;
        }
        return done;
    }

    /// Forgets all frames so far.
    void restart()
    {
        m_frames.clear();
        m_worstStretch = 0;
    }
    std::size_t frames() const { return m_frames.size(); }
    /// Milliseconds that no more than this share of the frames take longer; 1: the worst.
    double frameMs(double share) const
    {
        if (m_frames.empty())
            return 0;
        auto sorted = m_frames;
        std::sort(sorted.begin(), sorted.end());
        return static_cast<double>(sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))]) / 1e6;
    }
    double meanFrameMs() const
    {
        const auto sum = static_cast<double>(std::accumulate(m_frames.begin(), m_frames.end(), qint64(0)));
        return m_frames.empty() ? 0 : sum / static_cast<double>(m_frames.size()) / 1e6;
    }
    /// Of the longest time without a pause, with or without a frame.
    double worstStretchMs() const { return static_cast<double>(m_worstStretch) / 1e6; }

private:
    static constexpr qint64 kIdle = 200'000; // ns

    QElapsedTimer m_clock;
    std::vector<qint64> m_frames;
    qint64 m_stretch = 0, m_frame = 0, m_end = 0, m_worstStretch = 0;
    int m_depth = 0;
};

} // namespace skyseal::test
