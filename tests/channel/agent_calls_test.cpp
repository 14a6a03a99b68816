// Whom a station calls where, turn by turn, while agents and addresses come and go: few at a time, and every agent at every
// address within a bounded number of turns.
#include "core/channel/agent_calls.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

#include <algorithm>
#include <set>

using namespace skyseal;
using namespace skyseal::channel;
using namespace std::chrono_literals;

namespace {

PublicKey agent(std::uint8_t number)
{
    return {number};
}
Path place(std::uint32_t number)
{
    return {LinkId{number}, {}};
}

/// Up to `most` numbers from 1 on, in any order.
std::vector<std::uint8_t> anySubset(std::uint8_t most)
{
    std::vector<std::uint8_t> out;
    for (std::uint8_t number = 1; number <= most; ++number) {
        if (*rc::gen::arbitrary<bool>())
            out.push_back(number);
    }
    return out;
}

bool contains(const auto &all, const auto &one)
{
    return std::ranges::find(all, one) != all.end();
}

} // namespace

class AgentCallsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everybodyIsReachedWhateverChanges();
    void returningAddressGoesOnWithItsNextAgents();
    void unchangedListsTakeNoMoreTurnsThanGroups();
    void memoryOfRemovedAddressesIsBounded();
};

/// The agent 0 and the address 0 stay; up to 11 others of each come and go between any two turns.
void AgentCallsTest::everybodyIsReachedWhateverChanges()
{
    QVERIFY(rc::check("each pair that stays listed has its turn", [] {
        const auto agents = *rc::gen::inRange<std::uint8_t>(0, 11), places = *rc::gen::inRange<std::uint8_t>(0, 11);
        const std::size_t bound = (places + 1u) * ((agents + 1u + AgentCalls::kAtOnce - 1) / AgentCalls::kAtOnce);
        AgentCalls calls;
        TimePoint now{1h};
        std::size_t waited = 0;
        for (int turn = 0; turn < 100; ++turn, now += AgentCalls::kTurn) {
            std::vector<PublicKey> listed{agent(0)};
            for (const std::uint8_t number : anySubset(agents))
                listed.insert(listed.begin(), agent(number));
            std::vector<Path> at{place(0)};
            for (const std::uint8_t number : anySubset(places))
                at.insert(at.begin(), place(number));
            const AgentCalls::Turn taken = calls.take(now, listed, at);
            RC_ASSERT(calls.nextTurn() == now + AgentCalls::kTurn);
            RC_ASSERT(taken.agents.size() == std::min(listed.size(), AgentCalls::kAtOnce));
            RC_ASSERT(taken.places.size() == std::min(at.size(), AgentCalls::kAtOnce));
            RC_ASSERT(std::ranges::all_of(taken.agents, [&](const PublicKey &one) { return contains(listed, one); }));
            RC_ASSERT(std::ranges::all_of(taken.places, [&](const Path &one) { return contains(at, one); }));
            const bool called = contains(taken.agents, agent(0)) && contains(taken.places, place(0));
            RC_ASSERT(!called || calls.lastCall(place(0)) == now);
            waited = called ? 0 : waited + 1;
            RC_ASSERT(waited < bound);
        }
    }));
}

/// An address that is listed for one turn in six, as one from which MAVLink comes.
void AgentCallsTest::returningAddressGoesOnWithItsNextAgents()
{
    std::vector<PublicKey> agents;
    for (std::uint8_t number = 0; number < 20; ++number)
        agents.push_back(agent(number));
    AgentCalls calls;
    std::set<PublicKey> reached;
    TimePoint now{1h};
    for (int visit = 0; visit < 5; ++visit) {
        for (int turn = 0; turn < 5; ++turn, now += AgentCalls::kTurn)
            calls.take(now, agents, {place(1), place(2)});
        // The others are served first; it waits for two turns at most.
        for (int turn = 0; turn < 3 && !(calls.lastCall(place(3)) && now - *calls.lastCall(place(3)) < 25s); ++turn) {
            const AgentCalls::Turn taken = calls.take(now += AgentCalls::kTurn, agents, {place(1), place(2), place(3)});
            if (contains(taken.places, place(3)))
                reached.insert(taken.agents.begin(), taken.agents.end());
        }
    }
    QVERIFY2(reached.size() >= 16, qPrintable(QString::number(reached.size())));
}

void AgentCallsTest::unchangedListsTakeNoMoreTurnsThanGroups()
{
    std::vector<PublicKey> agents;
    std::vector<Path> places;
    for (std::uint8_t number = 0; number < 18; ++number) {
        agents.push_back(agent(number));
        places.push_back(place(number));
    }
    AgentCalls calls;
    std::set<std::pair<PublicKey, Path>> reached;
    for (int turn = 0; turn < 25; ++turn) {
        const AgentCalls::Turn taken = calls.take(TimePoint{1h}, agents, places);
        for (const PublicKey &one : taken.agents) {
            for (const Path &at : taken.places)
                reached.emplace(one, at);
        }
    }
    QCOMPARE(reached.size(), agents.size() * places.size());
}

void AgentCallsTest::memoryOfRemovedAddressesIsBounded()
{
    AgentCalls calls;
    for (std::uint32_t number = 0; number < 1000; ++number)
        calls.take(TimePoint{1h}, {agent(1)}, {place(number)});
    std::size_t kept = 0;
    for (std::uint32_t number = 0; number < 1000; ++number)
        kept += calls.lastCall(place(number)).has_value();
    QCOMPARE(kept, AgentCalls::kKept + 1);
}

SKYSEAL_TEST_APPLESS(AgentCallsTest)
#include "agent_calls_test.moc"
