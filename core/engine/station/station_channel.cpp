#include "core/engine/station/station_channel.h"

#include "core/channel/endpoint.h"
#include "core/engine/common/dialect_traits.h"
#include "core/engine/station/snapshot.h"
#include "core/keys/public_key_text.h"
#include "core/link/address_text.h"

namespace skyseal::engine {

namespace {

channel::Endpoint makeEndpoint(TimePoint now, const channel::Policy &policy, SecretFiles &secrets)
{
    channel::Config config;
    config.role = channel::Role::Station;
    config.identity = secrets.identity;
    config.peers = secrets.peers;
    config.policy = policy;
    config.messageTraits = std::make_shared<DialectTraits>(mavlink::Dialect::builtin());
    return {std::move(config), secrets.random, *secrets.counters, now};
}

} // namespace

StationChannel::StationChannel(TimePoint now, const channel::Policy &policy, SecretFiles &secrets, LinkPool &links,
                               PairingDriver::Notify notify)
    : driver(makeEndpoint(now, policy, secrets), links), pairing(links, secrets.random, std::move(notify)),
      unanswering(keys::fingerprint(secrets.publicKey()))
{}

bool StationChannel::switchAll(TimePoint now, crypto::SuiteId suite)
{
    bool anyHeard = false;
    for (const channel::SessionId session : endpoint().sessions()) {
        anyHeard = anyHeard || !endpoint().sessionInfo(session)->silent;
        endpoint().switchSuite(now, session, suite);
    }
    return anyHeard;
}

std::vector<AgentUnanswering> StationChannel::updateUnanswering(TimePoint now)
{
    return unanswering.update(now, endpoint().unanswered());
}

void StationChannel::sampleQuarter()
{
    for (const channel::SessionId session : endpoint().sessions()) {
        if (const auto stats = endpoint().stats(session))
            sessions.noteQuarter(session, *stats);
    }
}

void StationChannel::sampleSecond()
{
    for (const channel::SessionId session : endpoint().sessions()) {
        if (const auto stats = endpoint().stats(session))
            sessions.noteSecond(session, *stats);
    }
}

SessionSnapshot StationChannel::describe(TimePoint now, const channel::SessionInfo &info) const
{
    SessionSnapshot out;
    out.info = info;
    if (const auto stats = endpoint().stats(info.session))
        out.stats = *stats;
    out.cost = driver.costs().of(info.session);
    out.fingerprint = keys::fingerprint(info.peer);
    out.remoteAddress = link::toText(info.path.remote);
    out.age = seconds(now - info.since);
    sessions.describe(info.session, out);
    return out;
}

void StationChannel::describe(TimePoint now, Snapshot &out) const
{
    for (const channel::SessionId session : endpoint().sessions()) {
        if (const auto info = endpoint().sessionInfo(session))
            out.sessions.push_back(describe(now, *info));
    }
    out.unanswering = unanswering.all();
    out.unknownAgents = unknownAgents.all(now);
    out.unmatched = endpoint().unmatched();
}

} // namespace skyseal::engine
