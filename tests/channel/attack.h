// Common parts of the attack tests: a pair under a given suite, a captured record, and a check that the state is the same
// as before the attack.
#pragma once

#include "pair.h"
#include "tap.h"

#include <memory>
#include <optional>
#include <vector>

namespace skyseal::test {

using namespace std::chrono_literals;
using crypto::SuiteId;

inline constexpr std::uint64_t kAttackSeed = 20240607;

PairOptions attackOptions();

std::unique_ptr<Pair> pairUnder(SuiteId suite, WireModel link = {});

struct Caught
{
    SentDatagram flight;
    std::uint64_t number = 0;
};

/// Seals one frame from the agent and keeps the record off the wire.
Caught catchOne(Pair &pair, std::size_t size = 28, Side from = Air);

/// Passes a datagram to an endpoint; returns true if it yielded frames.
bool offer(Pair &pair, Side to, Bytes bytes, std::optional<Path> from = {});

/// Delivers all of them to their receivers at once; returns the number of accepted ones.
std::size_t offerAll(Pair &pair, const std::vector<SentDatagram> &flights);

std::uint32_t counterOf(ByteView record);
void setCounter(Bytes &record, std::uint32_t counter);

ReceiveCounters received(const Pair::End &end);
std::uint64_t refused(const ReceiveCounters &c);
std::uint64_t refusedInAll(const Pair::End &end);

/// Returns true if the session that existed before still carries frames in both directions.
bool aliveAndExact(Pair &pair);

} // namespace skyseal::test
