// A pair that exchanges real MAVLink frames, sealed in place where the session has inline framing.
#pragma once

#include "core/crypto/inline_cipher.h"
#include "core/engine/common/dialect_traits.h"
#include "core/mavlink/frame_writer.h"
#include "pair.h"

#include <QtTest/QTest>

#include <algorithm>

namespace skyseal::test {

using crypto::SuiteId;
using namespace std::chrono_literals;

/// A real frame: the number that Pair expects, then bytes other than zero.
inline Bytes numberedFrame(std::uint64_t number, std::size_t size)
{
    static const mavlink::MessageInfo &info = *mavlink::Dialect::builtin().find("COMMAND_LONG");
    Bytes payload(std::clamp<std::size_t>(size, 9, 255), 0x42);
    for (std::size_t i = 0; i < 8; ++i)
        payload[i] = static_cast<std::uint8_t>(number >> (8 * i));
    Bytes out(mavlink::kMaxFrameLength);
    const auto frame = mavlink::writeFrame(out, 2, static_cast<std::uint8_t>(number), 1, 1, info.id, info.crcExtra,
                                           info.minLength, payload);
    out.resize(frame.size());
    return out;
}

inline PairOptions inlineOptions(std::uint64_t seed = 7)
{
    PairOptions options;
    options.seed = seed;
    options.messageTraits = std::make_shared<engine::DialectTraits>(mavlink::Dialect::builtin());
    options.makeFrame = numberedFrame;
    options.ground.allowInline = options.ground.preferInline = true;
    options.air.allowInline = true;
    return options;
}

/// Both ends up and settled under a suite.
inline std::unique_ptr<Pair> inlinePair(SuiteId suite, PairOptions options = inlineOptions())
{
    auto pair = std::make_unique<Pair>(std::move(options));
    pair->run(5s, [&] { return pair->bothUp(); });
    pair->run(1s);
    pair->ground().switchSuite(pair->now, suite);
    pair->run(5s);
    return pair;
}

inline Framing framingOf(const Pair::End &end)
{
    return end.sessionInfo()->framing;
}

/// One row for each suite that can seal in place.
inline void everyInlineSuite()
{
    QTest::addColumn<int>("suite");
    for (const auto &info : crypto::suites()) {
        if (crypto::mayBeInline(info.id))
            QTest::newRow(info.name.data()) << static_cast<int>(info.id);
    }
}

} // namespace skyseal::test
