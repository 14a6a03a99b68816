#include "core/channel/endpoint_core.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kRefusalPause = std::chrono::seconds(1);

bool sendsClose(DownReason reason)
{
    return reason == DownReason::Closed || reason == DownReason::Revoked || reason == DownReason::Cloned;
}

} // namespace

bool isCausedByStrangers(RefusalReason reason)
{
    return reason == RefusalReason::WrongKey || reason == RefusalReason::UnknownPeer || reason == RefusalReason::Version
        || reason == RefusalReason::ReplayedHandshake || reason == RefusalReason::NoCommonSuite;
}

bool samePresharedKey(const std::shared_ptr<const Key32> &one, const std::shared_ptr<const Key32> &other)
{
    return one == other || (one && other && one->equals(*other));
}

EndpointCore::EndpointCore(Config configuration, RandomSource &random, CounterStore &store)
    : config(std::move(configuration)),
      counters(store), context{random, store, {}, {}, {}, config.timing, config.freshness, config.messageTraits.get()},
      ownMac(config.identity->publicKey), m_strangerEvents(kRefusalReasons, IntervalLimit(kRefusalPause, TimePoint::min()))
{
    updateOffer();
}

void EndpointCore::updateOffer()
{
    context.offer = offerOf(config.policy);
    std::erase_if(context.offer.suites, [](crypto::SuiteId suite) { return !crypto::suiteAvailable(suite); });
    context.offer.allowInline = context.offer.allowInline && context.traits;
    context.offer.preferInline = context.offer.preferInline && context.offer.allowInline;
}

const Peer *EndpointCore::peer(const PublicKey &key) const
{
    const auto found = std::find_if(config.peers.begin(), config.peers.end(), [&](const Peer &p) { return p.key == key; });
    return found == config.peers.end() ? nullptr : &*found;
}

void EndpointCore::notifyRefused(TimePoint now, const Path &path, RefusalReason reason, const PublicKey &key)
{
    // A station shows each agent that it does not know.
    const bool isUnknownAgent = config.role == Role::Station && reason == RefusalReason::UnknownPeer;
    if (isCausedByStrangers(reason) && !isUnknownAgent) {
        if (m_strangerEvents[static_cast<std::size_t>(reason)].take(now))
            context.events.push_back(HandshakeRefused{path, reason, key});
        return;
    }
    std::optional<Notified> *slot = nullptr;
    for (auto &notified : isUnknownAgent ? m_unknownAgents : m_otherRefusals) {
        const bool current = notified && now < notified->at + kRefusalPause;
        if (current && notified->path == path)
            return;
        if (!current)
            slot = &notified;
    }
    if (!slot)
        return;
    *slot = Notified{path, now};
    context.events.push_back(HandshakeRefused{path, reason, key});
}

void EndpointCore::bringUp(TimePoint now, SessionTable::Entry &entry)
{
    Session &session = *entry.session;
    table.forEach([&](SessionTable::Entry &other) {
        const bool samePeer = other.session->peer().key == session.peer().key;
        // A serial carrier has one session, since its records need not name theirs.
        const bool sameLine = session.path().carrier == Carrier::Serial && other.session->path() == session.path();
        if (other.session.get() != &session && (samePeer || sameLine) && other.up)
            end(now, *other.session, DownReason::PeerRestarted);
    });
    entry.up = true;
    const SessionInfo info = session.info(now);
    context.events.push_back(SessionUp{info.session, info.peer, info.peerName, info.suite, info.path, session.agreedFraming()});
    session.policyChanged(now); // The policy may have become stricter during the handshake.
}

void EndpointCore::end(TimePoint now, Session &session, DownReason reason)
{
    const SessionTable::Entry *entry = table.find(session.id());
    if (entry && entry->up) {
        session.end(now, sendsClose(reason));
        context.events.push_back(SessionDown{session.id(), reason, session.stats(), session.agreedFraming()});
    }
    table.erase(session.id());
}

void EndpointCore::endFinished(TimePoint now)
{
    table.forEach([&](SessionTable::Entry &entry) {
        if (const auto reason = entry.session->finished())
            end(now, *entry.session, *reason);
    });
}

} // namespace skyseal::channel
