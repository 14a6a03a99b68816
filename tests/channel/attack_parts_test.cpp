// Long records pass MAVLink routers in parts that are not authenticated one by one. The receiver delivers one of the sent
// messages or none, however the parts are lost, repeated, delayed or mixed with those of other senders.
#include "core/channel/tunnel_parts.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <algorithm>
#include <random>

using namespace skyseal;
using namespace skyseal::channel;
using namespace std::chrono_literals;

namespace {

constexpr unsigned kSeed = 20240607;

std::vector<Bytes> partsOf(ByteView message, std::uint16_t set)
{
    std::vector<Bytes> out;
    writeParts(message, set, [&](ByteView payload) { out.emplace_back(payload.begin(), payload.end()); });
    return out;
}

} // namespace

class AttackPartsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void splicedTunnelParts();
    void partsOfSendersAreNotMixed();

private:
    Bytes message()
    {
        Bytes out(kTunnelPayload + 1 + m_random() % (kMaxTunnelled - kTunnelPayload));
        std::generate(out.begin(), out.end(), [this] { return static_cast<std::uint8_t>(m_random()); });
        return out;
    }
    bool chance(unsigned percent) { return m_random() % 100 < percent; }

    std::mt19937 m_random{kSeed};
};

void AttackPartsTest::splicedTunnelParts()
{
    std::size_t whole = 0;
    for (int round = 0; round < 500; ++round) {
        std::vector<Bytes> messages, wire;
        for (std::uint16_t set = 0; set < 8; ++set) {
            for (Bytes &part : partsOf(messages.emplace_back(message()), set)) {
                if (chance(30))
                    continue; // the first, the last or one between is missing
                if (chance(20))
                    wire.push_back(part);
                wire.push_back(std::move(part));
                if (chance(30) && wire.size() > 1)
                    std::swap(wire.back(), wire[wire.size() - 2]);
            }
        }
        TunnelReader reader;
        for (const Bytes &part : wire) {
            const auto got = reader.take(TimePoint{1s}, {}, part);
            if (!got)
                continue;
            ++whole;
            HOLDS(std::find(messages.begin(), messages.end(), Bytes(got->begin(), got->end())) != messages.end(),
                  "no message is put together of two");
        }
    }
    QVERIFY(whole > 500);
}

void AttackPartsTest::partsOfSendersAreNotMixed()
{
    const Path first{LinkId{1}, {}, Carrier::Tunnel, {1, 191}}, second{LinkId{1}, {}, Carrier::Tunnel, {2, 191}};
    const Bytes one(300, 0x50), other(300, 0x51);
    const auto ones = partsOf(one, 1), others = partsOf(other, 1);
    TunnelReader reader;
    QVERIFY(!reader.take(TimePoint{1s}, first, ones[0]));
    HOLDS(!reader.take(TimePoint{1s}, second, others[1]) && !reader.take(TimePoint{1s}, second, others[2]),
          "no message is put together of two senders'");
    QVERIFY(!reader.take(TimePoint{1s}, first, ones[1]));
    for (const auto &[path, last, whole] : {std::tuple(first, ones[2], one), std::tuple(second, others[0], other)}) {
        const auto got = reader.take(TimePoint{1s}, path, last);
        QVERIFY(got && Bytes(got->begin(), got->end()) == whole);
    }
}

SKYSEAL_TEST_APPLESS(AttackPartsTest)
#include "attack_parts_test.moc"
