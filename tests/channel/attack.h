// Common parts of the attack tests: a pair under a given suite, a captured record, and a check that the state is the same
// as before the attack.
#pragma once

#include "core/base/weakness.h"
#include "pair.h"
#include "tap.h"
#include "tests/support/holds.h"

#include <QtTest/QTest>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace skyseal::test {

using namespace std::chrono_literals;
using crypto::SuiteId;

inline constexpr std::uint64_t kAttackSeed = 20240607;

inline PairOptions attackOptions()
{
    PairOptions options;
    options.seed = kAttackSeed;
    return options;
}

inline std::unique_ptr<Pair> pairUnder(SuiteId suite, LinkModel link = {})
{
    PairOptions options = attackOptions();
    options.link = link;
    auto pair = std::make_unique<Pair>(options);
    pair->run(5s, [&] { return pair->bothUp(); });
    pair->run(1s);
    if (suite != SuiteId::ChaCha20Poly1305) {
        pair->ground().endpoint->switchSuite(pair->now, pair->ground().session(), suite);
        pair->run(5s);
    }
    return pair;
}

/// One row of a data-driven test for each suite of this machine.
inline void everySuite()
{
    QTest::addColumn<int>("suite");
    for (const auto &info : crypto::suites()) {
        if (info.id != SuiteId::None && crypto::suiteAvailable(info.id))
            QTest::newRow(info.name.data()) << static_cast<int>(info.id);
    }
}

struct Caught
{
    Flight flight;
    std::uint64_t number = 0;
};

/// Seals one frame from the agent and keeps the record off the wire.
inline Caught catchOne(Pair &pair, std::size_t size = 28, Side from = Air)
{
    Caught caught;
    const auto before = std::exchange(pair.link.attacker, [&caught](TimePoint, Flight &flight) {
        caught.flight = flight;
        return false;
    });
    caught.number = pair.sendFrame(from, size);
    pair.link.attacker = before;
    pair.dropped[from].erase(caught.number); // the test delivers it
    return caught;
}

/// Passes a datagram to an endpoint; returns true if it yielded frames.
inline bool offer(Pair &pair, Side to, Bytes bytes, std::optional<Path> from = {})
{
    const Path path = from.value_or(pair.pathOf(to == Air ? Ground : Air));
    return pair.ends[to].endpoint->handleDatagram(pair.now, path, bytes).has_value();
}

/// Delivers all of them to their receivers at once; returns the number of accepted ones.
inline std::size_t offerAll(Pair &pair, const std::vector<Flight> &flights)
{
    std::size_t taken = 0;
    for (const Flight &flight : flights)
        taken += offer(pair, flight.from == Air ? Ground : Air, flight.bytes);
    return taken;
}

inline std::uint32_t counterOf(ByteView record)
{
    return record[3] | record[4] << 8u | record[5] << 16u;
}
inline void setCounter(Bytes &record, std::uint32_t counter)
{
    for (unsigned k = 0; k < 3; ++k)
        record[3 + k] = static_cast<std::uint8_t>(counter >> 8 * k);
}

inline ReceiveCounters received(const Pair::End &end)
{
    return end.endpoint->stats(end.session())->rx;
}
inline std::uint64_t refused(const ReceiveCounters &c)
{
    return c.forged + c.replayed + c.malformed;
}
inline std::uint64_t refusedInAll(const Pair::End &end)
{
    return refused(received(end)) + refused(end.endpoint->unmatched());
}

/// Returns true if the session that existed before still carries frames in both directions.
inline bool aliveAndExact(Pair &pair)
{
    pair.run(10ms);
    const auto ground = pair.ground().delivered.size(), air = pair.air().delivered.size();
    for (int i = 0; i < 5; ++i) {
        pair.sendFrame(Air);
        pair.sendFrame(Ground);
    }
    pair.run(2s);
    return pair.ground().delivered.size() == ground + 5 && pair.air().delivered.size() == air + 5
        && pair.ground().all<SessionUp>().size() == 1 && pair.ground().all<SessionDown>().empty()
        && pair.accountFrom(Air).empty() && pair.accountFrom(Ground).empty();
}

} // namespace skyseal::test

#define PAIR_UNDER_SUITE                                                                                                       \
    QFETCH(int, suite);                                                                                                        \
    auto pairOwner = pairUnder(static_cast<SuiteId>(suite));                                                                   \
    Pair &pair = *pairOwner;                                                                                                   \
    QVERIFY(pair.bothUp());                                                                                                    \
    QCOMPARE(static_cast<int>(pair.ground().endpoint->sessionInfo(pair.ground().session())->suite), suite)
