#include "core/engine/text/common_event_text.h"

#include "core/engine/text/qt_text.h"
#include "core/engine/text/state_text.h"
#include "core/keys/public_key_text.h"
#include "core/link/address_text.h"
#include "core/mavlink/enums.h"

#include <QtCore/QCoreApplication>

namespace skyseal::engine {

namespace {

constexpr std::uint8_t kCritical = mavlink::MAV_SEVERITY_CRITICAL, kError = mavlink::MAV_SEVERITY_ERROR,
                       kWarning = mavlink::MAV_SEVERITY_WARNING, kInfo = mavlink::MAV_SEVERITY_INFO;

QString addressOf(const Path &path)
{
    return qt(link::toText(path.remote));
}

/// Calls the overload for the alternative that an event holds.
class DescribeChannel
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::engine::EventText)

public:
    explicit DescribeChannel(const PeerNames &names) : m_names(names) {}

    EventText operator()(const channel::SessionUp &e) const
    {
        return {tr("Sealed link to %1 at %2 is up with %3").arg(qt(e.peerName), addressOf(e.path), suiteText(e.suite)), kInfo};
    }
    EventText operator()(const channel::SessionDown &e) const
    {
        return {tr("Sealed link to %1 ended: %2").arg(peer(e.session), downReasonText(e.reason)), kWarning};
    }
    EventText operator()(const channel::PeerMoved &e) const
    {
        return {tr("The address of %1 changed to %2").arg(peer(e.session), addressOf(e.to)), kInfo};
    }
    EventText operator()(const channel::SwitchPending &e) const
    {
        return routineText(tr("Switching from %1 to %2").arg(suiteText(e.from), suiteText(e.to)));
    }
    EventText operator()(const channel::SwitchDone &e) const
    {
        const auto epoch = static_cast<quint32>(e.epoch);
        if (e.failure != channel::SwitchFailure::None)
            return {(e.rekey ? tr("Keys of %1 not changed: %2") : tr("Switch to %1 rolled back: %2"))
                        .arg(suiteText(e.to), switchFailureText(e.failure)),
                    kWarning};
        if (e.rekey)
            return {tr("New keys for %1, epoch %2, in %3").arg(suiteText(e.to)).arg(epoch).arg(switchTimeText(e.took)), kInfo};
        return {tr("Switched from %1 to %2, epoch %3, in %4")
                    .arg(suiteText(e.from), suiteText(e.to))
                    .arg(epoch)
                    .arg(switchTimeText(e.took)),
                kInfo};
    }
    EventText operator()(const channel::HandshakeRefused &e) const
    {
        const bool isKeyKnown = e.peer != channel::PublicKey{};
        // A station receives an announcement, which does not contain the key; an agent receives a handshake, which does.
        if (e.reason == channel::RefusalReason::UnknownPeer && !isKeyKnown)
            return {unknownAgentText(addressOf(e.path)), kWarning, 0, false, EventText::Remedy::PairAgent};
        const QString sentence = tr("Refused a handshake from %1: %2").arg(addressOf(e.path), refusalText(e.reason));
        return {isKeyKnown ? tr("%1 (key %2)").arg(sentence, qt(keys::fingerprint(e.peer))) : sentence, kWarning};
    }
    EventText operator()(const channel::ForgeryAlarm &e) const
    {
        return {tr("Under attack: refused %1 forged and %2 replayed records that claim to come from %3")
                    .arg(e.forged)
                    .arg(e.replayed)
                    .arg(peer(e.session)),
                kCritical};
    }

    EventText operator()(const channel::CommandsLate &e) const
    {
        const double age = double(e.report.ageMicroseconds) / 1e6, limit = double(e.report.limitMilliseconds) / 1e3;
        if (limit > 0 && !e.report.isAgeKnown())
            return {tr("%1 cannot determine the delay of commands and ignores any that may be older than %2 s: it ignored %3")
                        .arg(peer(e.session))
                        .arg(decimalText(limit, 1))
                        .arg(counted(e.records, tr("one message"), tr("%1 messages"))),
                    kError};
        if (limit > 0 && age > limit)
            return {tr("Commands reach %2 up to %1 s late, and it ignores any that are older than %3 s: it ignored %4")
                        .arg(decimalText(age, 1))
                        .arg(peer(e.session))
                        .arg(decimalText(limit, 1))
                        .arg(counted(e.records, tr("one message"), tr("%1 messages"))),
                    kError};
        return {tr("Messages to %1 were withheld or delayed in transit and overtaken by others: it ignored %2")
                    .arg(peer(e.session))
                    .arg(e.records),
                kError};
    }

    static EventText ofLink(const LinkSnapshot &link)
    {
        const QString url = qt(link.url);
        if (!link.problem.empty())
            return {tr("Link %1: %2").arg(url, reasonText(link.problem)), kError};
        switch (link.phase) {
        case LinkPhase::Listening: return {tr("Link %1: listening on %2").arg(url, qt(link.localAddress)), kInfo};
        case LinkPhase::Finished: return {tr("Link %1: replay finished").arg(url), kInfo};
        case LinkPhase::Opening:
        case LinkPhase::Closed: return routineText(tr("Link %1: %2").arg(url, linkPhaseText(link.phase)));
        default: return {tr("Link %1: %2").arg(url, linkPhaseText(link.phase)), kInfo};
        }
    }

    static QString lineOf(const EventText &text)
    {
        return text.systemId == 0 ? text.sentence : tr("Vehicle %1: %2").arg(text.systemId).arg(text.sentence);
    }
    EventText operator()(const channel::PeerStorageChanged &e) const
    {
        if (!e.failed)
            return {tr("The companion computer of %1 can store handshake counters again").arg(peer(e.session)),
                    mavlink::MAV_SEVERITY_NOTICE};
        return {peerCannotStoreText(peer(e.session)), kError};
    }

private:
    QString peer(channel::SessionId session) const
    {
        const std::string name = m_names.of(session);
        return name.empty() ? tr("the peer") : qt(name);
    }

    const PeerNames &m_names;
};

} // namespace

QString EventText::line() const
{
    return DescribeChannel::lineOf(*this);
}

EventText routineText(const QString &sentence, std::uint8_t systemId)
{
    return {sentence, kInfo, systemId, true};
}

QString unknownAgentText(const QString &address)
{
    return DescribeChannel::tr("An agent at %1 announces itself with an unknown key").arg(address);
}

QString peerCannotStoreText(const QString &peer)
{
    return DescribeChannel::tr(
               "The companion computer of %1 cannot store handshake counters; its disk may be full, read-only or "
               "broken. The link stays up. If that computer restarts now, it will answer replayed handshakes, "
               "but they cannot establish a session")
        .arg(peer);
}

EventText channelEventText(const channel::Event &event, const PeerNames &names)
{
    return std::visit(DescribeChannel(names), event);
}

EventText linkText(const LinkSnapshot &link)
{
    return DescribeChannel::ofLink(link);
}

} // namespace skyseal::engine
