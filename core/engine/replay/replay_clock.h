// Position of a replay on the time line of its recording: stands still, or moves with the clock at a factor.
#pragma once

#include "core/base/clock.h"

#include <algorithm>

namespace skyseal::engine {

class ReplayClock
{
public:
    static constexpr double kSlowest = 0.1, kFastest = 50;

    bool isPlaying() const { return m_playing; }
    double speed() const { return m_speed; }
    Duration position(TimePoint now) const
    {
        return m_playing ? m_position + std::chrono::duration_cast<Duration>((now - m_since) * m_speed) : m_position;
    }

    void setPlaying(TimePoint now, bool playing)
    {
        setPosition(now, position(now));
        m_playing = playing;
    }
    void setSpeed(TimePoint now, double factor)
    {
        setPosition(now, position(now));
        m_speed = factor > 0 ? std::clamp(factor, kSlowest, kFastest) : 1; // not a number: as recorded
    }
    void setPosition(TimePoint now, Duration position)
    {
        m_position = position;
        m_since = now;
    }

private:
    Duration m_position{};
    TimePoint m_since{};
    double m_speed = 1;
    bool m_playing = false;
};

} // namespace skyseal::engine
