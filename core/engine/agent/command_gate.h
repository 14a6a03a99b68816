// Decides which frames of authenticated stations reach the vehicle, by the sender policy, the rules for observers and the
// check for frames that could be misread, and counts the refused ones. No I/O and no clock.
#pragma once

#include "core/channel/delivery.h"
#include "core/engine/agent/agent_event.h"
#include "core/engine/agent/agent_snapshot.h"
#include "core/engine/agent/question_limit.h"
#include "core/engine/common/sender_policy.h"
#include "core/mavlink/frame_header.h"
#include "core/mavlink/frame_scanner.h"

#include <map>
#include <utility>
#include <vector>

namespace skyseal::engine {

class CommandGate
{
public:
    CommandGate() : m_policy(SecureMode::Required, Speakers::MayShareASystem) {}

    void setPeers(const std::vector<channel::Peer> &peers);
    void sessionUp(const channel::SessionUp &up);
    void sessionDown(channel::SessionId session);

    /// Judges a whole frame that arrived over a session; counts it if it is refused. The frames of a record that arrived too
    /// late have only the rights of an observer. `isVehicle` returns true for the system ids of the agent's own vehicles, which
    /// a station may not use.
    template<typename IsVehicle>
    bool accept(TimePoint now, const channel::Delivery &delivery, const mavlink::ScanItem &item, IsVehicle &&isVehicle)
    {
        return mayCommand(now, delivery, item)
            && maySpeakAs(delivery.session, item, isVehicle(mavlink::systemIdOf(item.bytes)));
    }

    /// Whether the station may send more than questions (read-only requests).
    bool mayCommand(channel::SessionId session) const { return m_policy.mayCommand(session); }
    /// Whether the system id belongs to a ground station: the customary one, and those that the list binds to pilots or that
    /// they have used since the start. Not those of observers, which could take the vehicle's.
    bool isGroundSystem(std::uint8_t systemId) const;

    /// The refusals since the last call.
    std::vector<FramesRefused> takeRefused();
    /// Adds the frames that were refused since the start.
    void addTo(AgentCounters &counters) const;

private:
    bool mayCommand(TimePoint now, const channel::Delivery &delivery, const mavlink::ScanItem &item);
    bool maySpeakAs(channel::SessionId session, const mavlink::ScanItem &item, bool isVehicle);
    void refuse(channel::SessionId session, const mavlink::ScanItem &item, FramesRefused::Reason reason);

    struct Sender
    {
        channel::PublicKey key{};
        std::string name;
    };

    SenderPolicy m_policy;
    QuestionLimit m_questions;
    std::map<channel::SessionId, Sender> m_senders;
    std::map<std::pair<channel::SessionId, FramesRefused::Reason>, FramesRefused> m_pending;
    AgentCounters m_counters; ///< of refused frames alone
};

} // namespace skyseal::engine
