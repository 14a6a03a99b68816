// A pair in flight whose records an attacker or the link delays, and the freshness of the frames that arrive.
#pragma once

#include "attack.h"
#include "core/channel/inline_frame.h"
#include "inline_pair.h"

namespace skyseal::test {

inline constexpr Duration kOvertaken = 1s, kAge = 5s;

/// How frames travel: in records of each carrier, or sealed in place.
struct Way
{
    const char *name;
    Carrier carrier;
    bool inPlace = false;
};
inline constexpr Way kWays[] = {{"datagrams", Carrier::Datagram},
                                {"TUNNEL", Carrier::Tunnel},
                                {"serial", Carrier::Serial},
                                {"sealed in place", Carrier::Datagram, true}};
inline constexpr Way kRecords = kWays[0];

inline PairOptions optionsWith(const Way &way, std::optional<Duration> age)
{
    PairOptions options = way.inPlace ? inlineOptions(kAttackSeed) : attackOptions();
    if (way.inPlace)
        std::stable_partition(options.ground.suites.begin(), options.ground.suites.end(), crypto::mayBeInline);
    options.carrier = way.carrier;
    options.freshness = {kOvertaken, age};
    return options;
}

/// A pair in flight: the station sends a heartbeat a second, the agent telemetry.
inline std::unique_ptr<Pair> flight(PairOptions options)
{
    auto pair = std::make_unique<Pair>(std::move(options));
    pair->run(60s, [&] { return pair->bothUp(); });
    pair->every(1s, [p = pair.get()] { p->sendFrame(Ground); });
    pair->every(100ms, [p = pair.get()] { p->sendFrame(Air); });
    pair->run(5s);
    return pair;
}

/// Delivers a caught record, or frame sealed in place, to its receiver. Returns the judgement, nullopt if it is refused.
inline std::optional<Freshness> release(Pair &pair, const Caught &caught)
{
    const Side from = caught.flight.from, to = from == Ground ? Air : Ground;
    Bytes bytes = caught.flight.bytes;
    Pair::End &end = pair.ends[to];
    const auto delivery = looksInline(bytes) ? end.handleInlineFrame(pair.nowAt(to), pair.pathOf(from), bytes)
                                             : end.handleDatagram(pair.nowAt(to), pair.pathOf(from), bytes);
    pair.pump();
    return delivery ? std::optional(delivery->freshness) : std::nullopt;
}

inline bool commands(std::optional<Freshness> freshness)
{
    return freshness == Freshness::Fresh;
}

/// Fresh frames of the station that the agent received more than `most` after they were sent.
inline std::size_t freshAndOlder(const Pair &pair, Duration most)
{
    std::size_t out = 0;
    for (const auto &[number, freshness] : pair.ends[Air].freshness)
        out += freshness == Freshness::Fresh && pair.ends[Air].arrived.at(number) - pair.sentAt.at(number) > most;
    return out;
}

/// Share of the station's frames from `since` on that the agent received as fresh.
inline double shareOfFresh(const Pair &pair, TimePoint since)
{
    double all = 0, fresh = 0;
    for (const auto &[number, freshness] : pair.ends[Air].freshness) {
        if (pair.sentAt.at(number) < since)
            continue;
        ++all;
        fresh += freshness == Freshness::Fresh;
    }
    return all == 0 ? 0 : fresh / all;
}

} // namespace skyseal::test
