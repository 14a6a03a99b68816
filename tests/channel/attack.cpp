#include "attack.h"

#include <utility>

namespace skyseal::test {

PairOptions attackOptions()
{
    PairOptions options;
    options.seed = kAttackSeed;
    return options;
}

std::unique_ptr<Pair> pairUnder(SuiteId suite, WireModel link)
{
    PairOptions options = attackOptions();
    options.link = link;
    auto pair = std::make_unique<Pair>(options);
    pair->run(5s, [&] { return pair->bothUp(); });
    pair->run(1s);
    if (suite != SuiteId::ChaCha20Poly1305) {
        pair->ground().switchSuite(pair->now, suite);
        pair->run(5s);
    }
    return pair;
}

Caught catchOne(Pair &pair, std::size_t size, Side from)
{
    Caught caught;
    const auto before = std::exchange(pair.link.attacker, [&caught](TimePoint, SentDatagram &flight) {
        caught.flight = flight;
        return false;
    });
    caught.number = pair.sendFrame(from, size);
    pair.link.attacker = before;
    pair.dropped[from].erase(caught.number); // the test delivers it
    return caught;
}

bool offer(Pair &pair, Side to, Bytes bytes, std::optional<Path> from)
{
    const Path path = from.value_or(pair.pathOf(to == Air ? Ground : Air));
    return pair.ends[to].handleDatagram(pair.now, path, bytes).has_value();
}

std::size_t offerAll(Pair &pair, const std::vector<SentDatagram> &flights)
{
    std::size_t taken = 0;
    for (const SentDatagram &flight : flights)
        taken += offer(pair, flight.from == Air ? Ground : Air, flight.bytes);
    return taken;
}

std::uint32_t counterOf(ByteView record)
{
    return record[3] | record[4] << 8u | record[5] << 16u;
}

void setCounter(Bytes &record, std::uint32_t counter)
{
    for (unsigned k = 0; k < 3; ++k)
        record[3 + k] = static_cast<std::uint8_t>(counter >> 8 * k);
}

ReceiveCounters received(const Pair::End &end)
{
    const auto stats = end.stats();
    return stats ? stats->rx : ReceiveCounters{};
}

std::uint64_t refused(const ReceiveCounters &c)
{
    return c.forged + c.replayed + c.malformed;
}

std::uint64_t refusedInAll(const Pair::End &end)
{
    return refused(received(end)) + refused(end.unmatched());
}

bool aliveAndExact(Pair &pair)
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
