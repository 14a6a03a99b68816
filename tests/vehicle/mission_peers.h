// The mission protocol as ArduPilot and PX4 serve it, through a ScriptedPeer's link: what is repeated, refused, ignored and
// ended by time-out. From ArduPilot's GCS_MAVLink/MissionItemProtocol.cpp and GCS_Common.cpp, and PX4's mavlink_mission.cpp.
#pragma once

#include "lossy_link.h"

#include <memory>

namespace skyseal::vehicle {

template<typename Message> Message toUs(std::uint16_t sequence = 0)
{
    Message out;
    out.target_system = 255;
    out.target_component = 190;
    if constexpr (requires { out.seq; })
        out.seq = sequence;
    if constexpr (requires { out.count; })
        out.count = sequence;
    return out;
}

inline mavlink::MissionAck acknowledgement(std::uint8_t result)
{
    auto out = toUs<mavlink::MissionAck>();
    out.type = result;
    return out;
}

class MissionPeer : public ScriptedPeer
{
public:
    std::vector<mavlink::MissionItemInt> stored;

    void fill(std::size_t count)
    {
        stored.assign(count, {});
        for (std::size_t i = 0; i < count; ++i) {
            stored[i].seq = static_cast<std::uint16_t>(i);
            stored[i].x = static_cast<std::int32_t>(i);
        }
    }

    void handle(TimePoint now, const OutMessage &message, std::vector<ToStation> &out) override
    {
        m_out = &out;
        const auto offer = [&]<typename Message>(std::type_identity<Message>, auto take) {
            if (const auto typed = as<Message>(message)) {
                m_type = typed->mission_type;
                take(*typed);
            }
        };
        using std::type_identity;
        offer(type_identity<mavlink::MissionCount>(), [&](const auto &m) { handleCount(now, m.count); });
        offer(type_identity<mavlink::MissionItemInt>(), [&](const auto &m) { handleItem(now, m); });
        offer(type_identity<mavlink::MissionRequestList>(), [&](const auto &) { handleList(now); });
        offer(type_identity<mavlink::MissionRequestInt>(), [&](const auto &m) { handleRequest(now, m.seq); });
        offer(type_identity<mavlink::MissionClearAll>(), [&](const auto &) { handleClear(); });
        offer(type_identity<mavlink::MissionAck>(), [&](const auto &m) { handleAck(m.type); });
    }
    void handleDeadline(TimePoint now, std::vector<ToStation> &out) override
    {
        m_out = &out;
        handleTimer(now);
    }

protected:
    virtual void handleCount(TimePoint now, std::uint16_t count) = 0;
    virtual void handleItem(TimePoint now, const mavlink::MissionItemInt &item) = 0;
    virtual void handleList(TimePoint now) = 0;
    virtual void handleRequest(TimePoint now, std::uint16_t sequence) = 0;
    virtual void handleClear() = 0;
    virtual void handleAck(std::uint8_t) {}
    virtual void handleTimer(TimePoint now) = 0;

    template<typename Message> void say(Message message)
    {
        message.mission_type = m_type;
        m_out->push_back(send(message));
    }
    void acknowledge(std::uint8_t result) { say(acknowledgement(result)); }
    void announce() { say(toUs<mavlink::MissionCount>(static_cast<std::uint16_t>(stored.size()))); }
    void sendItem(std::uint16_t sequence)
    {
        auto item = stored.at(sequence);
        item.target_system = 255;
        item.target_component = 190;
        say(item);
    }
    void request() { say(toUs<mavlink::MissionRequestInt>(static_cast<std::uint16_t>(m_next))); }

    std::vector<mavlink::MissionItemInt> m_receiving;
    std::size_t m_next = 0; ///< expected from the station, or by it
    TimePoint m_heard{}, m_asked{};

private:
    std::vector<ToStation> *m_out = nullptr;
    std::uint8_t m_type = 0;
};

class ArduPilotMissionPeer : public MissionPeer
{
public:
    TimePoint nextDeadline() const override
    {
        return m_active ? std::min(m_heard + std::chrono::seconds(8), m_asked + std::chrono::seconds(1)) : kNever;
    }

protected:
    void handleCount(TimePoint now, std::uint16_t count) override
    {
        m_receiving.assign(count, {});
        m_next = 0;
        m_active = true;
        m_heard = now;
        ask(now);
    }
    void handleItem(TimePoint now, const mavlink::MissionItemInt &item) override
    {
        if (!m_active)
            return acknowledge(mavlink::MAV_MISSION_ERROR);
        if (item.seq != m_next)
            return acknowledge(mavlink::MAV_MISSION_INVALID_SEQUENCE);
        m_receiving[m_next++] = item;
        m_heard = now;
        ask(now);
    }
    void handleList(TimePoint) override
    {
        if (m_active)
            return acknowledge(mavlink::MAV_MISSION_DENIED);
        announce();
    }
    void handleRequest(TimePoint, std::uint16_t sequence) override
    {
        if (m_active)
            return acknowledge(mavlink::MAV_MISSION_DENIED);
        if (sequence < stored.size())
            return sendItem(sequence);
        announce();
        acknowledge(mavlink::MAV_MISSION_ERROR);
    }
    void handleClear() override
    {
        if (m_active)
            return acknowledge(mavlink::MAV_MISSION_ERROR);
        stored.clear();
        acknowledge(mavlink::MAV_MISSION_ACCEPTED);
    }
    void handleTimer(TimePoint now) override
    {
        if (now < m_heard + std::chrono::seconds(8))
            return ask(now);
        m_active = false;
        acknowledge(mavlink::MAV_MISSION_OPERATION_CANCELLED);
    }

private:
    void ask(TimePoint now)
    {
        m_asked = now;
        if (m_next < m_receiving.size())
            return request();
        m_active = false;
        stored = m_receiving;
        acknowledge(mavlink::MAV_MISSION_ACCEPTED); // once: it may get lost
    }

    bool m_active = false;
};

class Px4MissionPeer : public MissionPeer
{
public:
    TimePoint nextDeadline() const override
    {
        switch (m_state) {
        case State::Idle: return kNever;
        case State::Sending: return m_heard + std::chrono::seconds(5);
        case State::Receiving: break;
        }
        return std::min(m_heard + std::chrono::seconds(5), m_asked + std::chrono::milliseconds(250));
    }

protected:
    void handleCount(TimePoint now, std::uint16_t count) override
    {
        if (m_state == State::Sending)
            return acknowledge(mavlink::MAV_MISSION_ERROR);
        m_heard = now;
        if (m_state == State::Receiving && m_next > 0)
            return acknowledge(mavlink::MAV_MISSION_ERROR);
        m_receiving.assign(count, {});
        m_next = 0;
        if (count == 0) {
            stored.clear();
            return acknowledge(mavlink::MAV_MISSION_ACCEPTED);
        }
        m_state = State::Receiving;
        ask(now);
    }
    void handleItem(TimePoint now, const mavlink::MissionItemInt &item) override
    {
        if (m_state == State::Idle)
            return acknowledge(item.seq + std::size_t(1) == m_next ? mavlink::MAV_MISSION_ACCEPTED
                                                                   : mavlink::MAV_MISSION_ERROR);
        if (m_state == State::Sending)
            return acknowledge(mavlink::MAV_MISSION_ERROR);
        m_heard = now;
        if (item.seq != m_next)
            return; // without a word
        m_receiving[m_next++] = item;
        if (m_next < m_receiving.size())
            return ask(now);
        m_state = State::Idle;
        stored = m_receiving;
        acknowledge(mavlink::MAV_MISSION_ACCEPTED);
    }
    void handleList(TimePoint now) override
    {
        if (m_next == stored.size())
            m_state = State::Idle; // perhaps only the acknowledgement was lost
        if (m_state == State::Receiving)
            return;
        m_heard = now;
        m_state = State::Sending;
        m_next = 0;
        announce();
    }
    void handleRequest(TimePoint now, std::uint16_t sequence) override
    {
        if (m_state != State::Sending)
            return;
        m_heard = now;
        if (sequence == m_next && m_next < stored.size()) {
            ++m_next;
        } else if (sequence + std::size_t(1) != m_next) {
            m_state = State::Idle;
            return acknowledge(mavlink::MAV_MISSION_ERROR);
        }
        sendItem(sequence);
    }
    void handleClear() override
    {
        if (m_state != State::Idle)
            return; // without a word
        stored.clear();
        acknowledge(mavlink::MAV_MISSION_ACCEPTED);
    }
    void handleAck(std::uint8_t result) override
    {
        if (m_state == State::Sending || result == mavlink::MAV_MISSION_OPERATION_CANCELLED)
            m_state = State::Idle;
    }
    void handleTimer(TimePoint now) override
    {
        if (m_state == State::Receiving && now < m_heard + std::chrono::seconds(5))
            return ask(now);
        m_state = State::Idle;
    }

private:
    enum class State : std::uint8_t { Idle, Receiving, Sending };

    void ask(TimePoint now)
    {
        m_asked = now;
        request();
    }

    State m_state = State::Idle;
};

inline std::unique_ptr<MissionPeer> missionPeer(bool isPx4)
{
    if (isPx4)
        return std::make_unique<Px4MissionPeer>();
    return std::make_unique<ArduPilotMissionPeer>();
}

} // namespace skyseal::vehicle
