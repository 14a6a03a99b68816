// The conversation that the simulated copter and a real ArduCopter are both asked to hold, and the facts that come out of it:
// rates of the streams, answers in their order, ranges of fields.
#pragma once

#include "core/base/bytes.h"
#include "core/mavlink/frame_writer.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace skyseal::sim {

/// A vehicle at the other end of some link, whose time passes while run() is called.
class ReferencePeer
{
public:
    virtual ~ReferencePeer() = default;

    virtual void send(ByteView frame) = 0;
    /// Lets `seconds` of the vehicle's time pass, with a heartbeat each second. Returns false if the vehicle stopped.
    virtual bool run(double seconds) = 0;

    std::vector<Bytes> received; ///< every frame so far
};

struct ReferenceFacts
{
    using Range = std::pair<double, double>;

    std::map<std::string, double> silentRates;               ///< Hz by message, before anything was requested
    std::map<std::string, double> rates;                     ///< Hz by message, after the requests of the station
    std::map<std::string, std::vector<std::string>> answers; ///< by step, in the order of their arrival
    std::map<std::string, Range> ranges;                     ///< by MESSAGE.field, on the ground and at rest

    std::string toText() const;
    static ReferenceFacts fromText(const std::string &text);
};

/// Holds the conversation, which ends on the ground. Returns what was observed; `problem` says what went wrong, or is empty.
ReferenceFacts holdConversation(ReferencePeer &peer, std::string &problem);

} // namespace skyseal::sim
