#include "core/channel/endpoint_core.h"

#include "core/base/weakness.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kRefusalPause = std::chrono::seconds(1);

bool sayGoodbyeFor(DownReason reason)
{
    return reason == DownReason::Closed || reason == DownReason::Revoked;
}

} // namespace

bool samePresharedKey(const std::shared_ptr<const Key32> &one, const std::shared_ptr<const Key32> &other)
{
    return one == other || (one && other && one->equals(*other));
}

EndpointCore::EndpointCore(Config configuration, RandomSource &random, CounterStore &store)
    : config(std::move(configuration)), counters(store), around{random, {}, {}, {}, config.timing, config.messageTraits.get()},
      ownMac(config.identity->publicKey)
{
    offerPolicy();
}

void EndpointCore::offerPolicy()
{
    around.offer = offerOf(config.policy);
    std::erase_if(around.offer.suites, [](crypto::SuiteId suite) { return !crypto::suiteAvailable(suite); });
    around.offer.allowInline = around.offer.allowInline && around.facts;
    around.offer.preferInline = around.offer.preferInline && around.offer.allowInline;
}

const Peer *EndpointCore::peer(const PublicKey &key) const
{
    const auto found = std::find_if(config.peers.begin(), config.peers.end(), [&](const Peer &p) { return p.key == key; });
    if (found == config.peers.end() && !config.peers.empty() && weakened(Weakness::NoPinning))
        return &config.peers.front();
    return found == config.peers.end() ? nullptr : &*found;
}

void EndpointCore::tellRefused(TimePoint now, const Path &path, RefusalReason reason, const PublicKey &key)
{
    if (weakened(Weakness::TellEverything))
        return around.events.push_back(HandshakeRefused{path, reason, key});
    std::optional<Told> *slot = nullptr;
    for (auto &told : m_notified) {
        const bool current = told && now < told->at + kRefusalPause;
        if (current && told->path == path)
            return;
        if (!current)
            slot = &told;
    }
    if (!slot)
        return;
    *slot = Told{path, now};
    around.events.push_back(HandshakeRefused{path, reason, key});
}

void EndpointCore::bringUp(TimePoint now, SessionTable::Entry &entry)
{
    Session &session = *entry.session;
    table.forEach([&](SessionTable::Entry &other) {
        const bool samePeer = other.session->peer().key == session.peer().key;
        // A line that only two share has one session: records on it need not name theirs.
        const bool sameLine = session.path().carrier == Carrier::Serial && other.session->path() == session.path();
        if (other.session.get() != &session && (samePeer || sameLine) && other.up)
            end(now, *other.session, DownReason::PeerRestarted);
    });
    entry.up = true;
    const SessionInfo info = session.info(now);
    around.events.push_back(SessionUp{info.session, info.peer, info.peerName, info.suite, info.path, session.agreedFraming()});
    session.policyChanged(now); // which may have been made stricter while the handshake was on its way
}

void EndpointCore::end(TimePoint now, Session &session, DownReason reason)
{
    const SessionTable::Entry *entry = table.find(session.id());
    if (entry && entry->up) {
        session.end(now, sayGoodbyeFor(reason));
        around.events.push_back(SessionDown{session.id(), reason, session.stats(), session.agreedFraming()});
    }
    table.erase(session.id());
}

void EndpointCore::reap(TimePoint now)
{
    table.forEach([&](SessionTable::Entry &entry) {
        if (const auto reason = entry.session->finished())
            end(now, *entry.session, *reason);
    });
}

} // namespace skyseal::channel
