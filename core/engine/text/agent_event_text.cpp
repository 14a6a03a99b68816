#include "core/engine/text/agent_event_text.h"

#include "core/engine/text/qt_text.h"
#include "core/keys/public_key_text.h"
#include "core/mavlink/enums.h"

#include <QtCore/QCoreApplication>

namespace skyseal::engine {

namespace {

class DescribeAgent
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::engine::AgentEventText)

public:
    explicit DescribeAgent(const PeerNames &names) : m_names(names) {}

    EventText operator()(const AgentLinkChanged &e) const
    {
        EventText text = linkText(e.link);
        text.sentence = (e.groundSide ? tr("Ground side: %1") : tr("Vehicle side: %1")).arg(text.sentence);
        return text;
    }
    EventText operator()(const channel::Event &e) const { return channelEventText(e, m_names); }
    EventText operator()(const channel::PairingEvent &) const { return routineText({}); }
    EventText operator()(const FramesRefused &e) const
    {
        QString message = e.messageName.empty() ? tr("message %1").arg(e.messageId) : qt(e.messageName);
        if (e.command != 0)
            message += QStringLiteral(" %1").arg(e.command);
        const QString count = e.reason == FramesRefused::Reason::TooOften
            ? counted(e.frames, tr("one request"), tr("%1 requests"))
            : counted(e.frames, tr("one frame"), tr("%1 frames"));
        const QString which = e.frames == 1 ? message : tr("most recently %1").arg(message);
        return {sentenceFor(e.reason).arg(count, qt(e.peer), which), std::uint8_t(mavlink::MAV_SEVERITY_WARNING)};
    }
    EventText operator()(const GroundIdClaimed &e) const
    {
        const QString sentence = tr("A device on the vehicle side uses system ID %1 of a ground station and is ignored; "
                                    "an autopilot needs a different ID");
        return {sentence.arg(e.systemId), std::uint8_t(mavlink::MAV_SEVERITY_ALERT)};
    }
    EventText operator()(const VehicleSignatures &e) const
    {
        using Kind = VehicleSignatures::Kind;
        if (e.kind == Kind::Verified)
            return {signingSentence(e.kind), std::uint8_t(mavlink::MAV_SEVERITY_NOTICE)};
        if (e.kind == Kind::TimeNotStored)
            return {signingSentence(e.kind).arg(qt(e.problem)), std::uint8_t(mavlink::MAV_SEVERITY_ERROR)};
        const QString count = counted(e.frames, tr("one frame"), tr("%1 frames"));
        return {signingSentence(e.kind).arg(count), std::uint8_t(mavlink::MAV_SEVERITY_WARNING)};
    }
    EventText operator()(const CounterStorage &e) const
    {
        if (e.problem.empty())
            return {tr("Handshake counters can be stored again"), std::uint8_t(mavlink::MAV_SEVERITY_NOTICE)};
        return {tr("Handshake counters cannot be stored: %1. The links stay up. If this agent restarts now, it will "
                   "answer replayed handshakes, but they cannot establish a session")
                    .arg(reasonText(e.problem)),
                std::uint8_t(mavlink::MAV_SEVERITY_ERROR)};
    }

private:
    static QString sentenceFor(FramesRefused::Reason reason)
    {
        switch (reason) {
        case FramesRefused::Reason::Observer: return tr("Refused %1 from %2, which is an observer: %3");
        case FramesRefused::Reason::System: return tr("Refused %1 from %2, which is not permitted to use that system ID: %3");
        case FramesRefused::Reason::TooOften: return tr("Refused %1 from %2, which sends requests too often: %3");
        case FramesRefused::Reason::Late: break;
        }
        return tr("Refused %1 from %2, received too late: %3");
    }

    static QString signingSentence(VehicleSignatures::Kind kind)
    {
        using Kind = VehicleSignatures::Kind;
        switch (kind) {
        case Kind::Verified: return tr("The vehicle signs its messages with the key of this agent");
        case Kind::Unsigned:
            return tr("Refused %1 without a signature on the vehicle side. If the vehicle sent them, set up its signing: "
                      "skyseal-air --signing setup");
        case Kind::Wrong: return tr("Refused %1 on the vehicle side, not signed with the key of this agent");
        case Kind::Old:
            return tr("Refused %1 on the vehicle side with an old signature: a replay, or the vehicle lost its signing "
                      "time, which recovers automatically");
        case Kind::Unsignable: return tr("Did not forward %1 from stations: MAVLink 1 cannot be signed");
        case Kind::KeyChange:
            return tr("Did not forward %1 from stations: only this agent may change the vehicle's signing key");
        case Kind::TooManySenders:
            return tr("Did not forward %1 from stations: the vehicle cannot track more signing senders until it restarts");
        case Kind::TimeNotStored: break;
        }
        return tr("The signing timestamp cannot be stored: %1. Signing continues");
    }

    const PeerNames &m_names;
};

} // namespace

EventText agentEventText(const AgentEvent &event, const PeerNames &names)
{
    return std::visit(DescribeAgent(names), event);
}

} // namespace skyseal::engine
