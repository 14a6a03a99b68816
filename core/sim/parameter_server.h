// Vehicle side of the parameter protocol (https://mavlink.io/en/services/parameter.html).
#pragma once

#include "core/sim/frame_queue.h"
#include "core/base/clock.h"
#include "core/sim/parameters.h"
#include "core/sim/status_texts.h"

namespace skyseal::sim {

class ParameterServer
{
public:
    ParameterServer(Parameters &parameters, FrameQueue &outbox, StatusTexts &texts)
        : m_parameters(parameters), m_outbox(outbox), m_texts(texts)
    {}

    /// PARAM_REQUEST_LIST: (re)starts sending all of them, at a pace that a radio can carry.
    void requestList(TimePoint now);
    /// PARAM_REQUEST_READ: by index, or by name if the index is negative. Unknown parameters get no answer.
    void requestRead(int index, std::string_view name);
    /// Sends the value of a parameter that the vehicle itself changed.
    void announce(std::string_view name);
    /// PARAM_SET: answered with the resulting value, whether it was accepted or not.
    void set(std::string_view name, float value);

    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const { return m_due; }

private:
    /// `listIndex`: param_index of the answer.
    void sendValue(std::size_t index, std::uint16_t listIndex);
    void sendHash();
    bool isPx4() const { return m_parameters.type().isPx4(); }
    /// An answer to a name carries no index in ArduPilot, and the index in PX4.
    std::uint16_t answerIndex(std::size_t index) const;

    Parameters &m_parameters;
    FrameQueue &m_outbox;
    StatusTexts &m_texts;
    bool m_hashDue = false; ///< PX4 begins a list with the hash of all values
    std::size_t m_next = 0;
    TimePoint m_due = kNever;
};

} // namespace skyseal::sim
