// The parameter protocol as ArduPilot serves it, through a ScriptedPeer's link.
#pragma once

#include "lossy_link.h"

#include <string>
#include <string_view>

namespace skyseal::vehicle {

inline mavlink::ParamValue value(std::string_view name, float content, std::uint16_t index, std::uint16_t count,
                                 std::uint8_t type = 9)
{
    mavlink::ParamValue out;
    mavlink::setText(out.param_id, name);
    out.param_value = content;
    out.param_type = type;
    out.param_index = index;
    out.param_count = count;
    return out;
}

/// Twelve characters, as most names have.
inline std::string nameOf(std::size_t index)
{
    const std::string number = std::to_string(10'000 + index);
    return "P" + number + "_" + number;
}

/// Has parameters and answers as ArduPilot does.
class ParameterPeer : public ScriptedPeer
{
public:
    explicit ParameterPeer(std::uint16_t count)
    {
        for (std::uint16_t i = 0; i < count; ++i)
            m_values.push_back(i * 0.5f);
    }

    void handle(TimePoint, const OutMessage &message, std::vector<ToStation> &out) override
    {
        if (as<mavlink::ParamRequestList>(message)) {
            for (std::uint16_t i = 0; i < m_values.size(); ++i)
                out.push_back(send(one(i)));
        }
        if (const auto read = as<mavlink::ParamRequestRead>(message))
            out.push_back(send(one(static_cast<std::uint16_t>(read->param_index))));
        if (const auto write = as<mavlink::ParamSet>(message)) {
            for (std::uint16_t i = 0; i < m_values.size(); ++i) {
                if (mavlink::textOf(write->param_id) == nameOf(i)) {
                    m_values[i] = write->param_value;
                    out.push_back(send(one(i)));
                }
            }
        }
    }

    float at(std::size_t index) const { return m_values[index]; }

protected:
    ToStation valueAt(std::uint16_t index) const { return send(one(index)); }

private:
    mavlink::ParamValue one(std::uint16_t index) const
    {
        return value(nameOf(index), m_values.at(index), index, static_cast<std::uint16_t>(m_values.size()));
    }

    std::vector<float> m_values;
};

/// Sends its list at a steady pace, and answers single requests at once.
class PacedPeer : public ParameterPeer
{
public:
    PacedPeer(std::uint16_t count, Duration pace) : ParameterPeer(count), m_count(count), m_pace(pace) {}

    void handle(TimePoint now, const OutMessage &message, std::vector<ToStation> &out) override
    {
        if (as<mavlink::ParamRequestList>(message)) {
            m_next = 0;
            m_due = now;
        } else {
            m_reads += as<mavlink::ParamRequestRead>(message).has_value();
            ParameterPeer::handle(now, message, out);
        }
    }
    void handleDeadline(TimePoint now, std::vector<ToStation> &out) override
    {
        out.push_back(valueAt(m_next++));
        m_due = m_next < m_count ? now + m_pace : kNever;
    }
    TimePoint nextDeadline() const override { return m_due; }
    int reads() const { return m_reads; }

private:
    const std::uint16_t m_count;
    const Duration m_pace;
    std::uint16_t m_next = 0;
    TimePoint m_due = kNever;
    int m_reads = 0;
};

} // namespace skyseal::vehicle
