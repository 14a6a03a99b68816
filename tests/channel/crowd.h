// One agent and several stations on one link, with a simulated clock.
#pragma once

#include "pair.h"

namespace skyseal::test {

/// One agent and several stations. Each station receives what is sent to no address; nothing is lost, and every datagram takes
/// one step, unless it is held back.
class Crowd
{
public:
    explicit Crowd(std::size_t stations);
    ~Crowd();

    void start(std::size_t station);
    /// The station uses another port from its next start on.
    void move(std::size_t station);
    void kill(std::size_t station);
    bool up(std::size_t station) const;
    std::vector<Event> &events(std::size_t station);

    /// Each station sends a frame at this interval from now on.
    void sendEvery(Duration interval) { m_interval = interval; }
    /// Holds back what this station sends, until release().
    void hold(std::size_t station);
    /// Delivers what was held back at once.
    void release(std::size_t station);
    /// A frame that came out at the agent.
    struct Heard
    {
        std::size_t station = 0;
        Duration age{};
        Freshness freshness{};
    };
    std::vector<Heard> heard;

    bool run(Duration span, const std::function<bool()> &until = {});
    /// Counts the announcements during `span`.
    int announcementsIn(Duration span);

private:
    struct End;

    Path pathOf(std::size_t station) const;
    void step();
    void sendFrames();
    void arrive(std::size_t station, Bytes bytes);

    SeededRandom m_random{20261121};
    TimePoint m_now{std::chrono::hours(1)};
    std::unique_ptr<End> m_air;
    std::vector<End> m_stations;
    Duration m_interval{};
    TimePoint m_nextFrames{};
    int m_announcements = 0;
};

} // namespace skyseal::test
