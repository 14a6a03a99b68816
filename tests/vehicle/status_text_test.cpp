// Status texts: long ones joined, lost and repeated chunks, the time-out, and what of it all a vehicle keeps.
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

#include "core/base/json_writer.h"
#include "core/vehicle/status_text_joiner.h"

using namespace skyseal;
using namespace skyseal::vehicle;

class StatusTextTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void joinsChunks();
    void fullLastChunkEndsWithAnEmptyOne();
    void lostChunkShowsAsAGap();
    void lateChunkIsPutInItsPlace();
    void repeatedChunkAddsNothing();
    void timeoutGivesWhatIsThere();
    void textsOfSeveralSendersInterleave();
    void manyBeginningsAreBounded();
    void characterThatIsSplitComesOutWhole();
    void vehicleNumbersAndKeepsTheLast200();
    void textsOfOtherComponentsAreHeard();
};

namespace {
const std::string kFirst(50, 'a');
const std::string kSecond(50, 'b');
} // namespace

void StatusTextTest::joinsChunks()
{
    StatusTextJoiner joiner;
    joiner.handleChunk(at(0), 1, 4, 9, 0, kFirst);
    QVERIFY(!joiner.poll());
    QCOMPARE(joiner.nextDeadline(), at(1));
    joiner.handleChunk(at(0.1), 1, 4, 9, 1, "end");
    const auto text = joiner.poll();
    QVERIFY(text);
    QCOMPARE(text->text, kFirst + "end");
    QCOMPARE(text->severity, std::uint8_t(4));
    joiner.handleDeadline(joiner.nextDeadline());
    QVERIFY(!joiner.poll());
    QCOMPARE(joiner.nextDeadline(), kNever);
}

void StatusTextTest::fullLastChunkEndsWithAnEmptyOne()
{
    StatusTextJoiner joiner;
    joiner.handleChunk(at(0), 1, 4, 9, 0, kFirst);
    joiner.handleChunk(at(0), 1, 4, 9, 1, kSecond);
    joiner.handleChunk(at(0), 1, 4, 9, 2, "");
    QCOMPARE(joiner.poll()->text, kFirst + kSecond);
}

void StatusTextTest::lostChunkShowsAsAGap()
{
    StatusTextJoiner joiner;
    joiner.handleChunk(at(0), 1, 4, 9, 0, kFirst);
    joiner.handleChunk(at(0), 1, 4, 9, 2, "end");
    joiner.handleChunk(at(0), 1, 4, 10, 1, "end");
    QVERIFY(!joiner.poll()); // what is missing may be late
    joiner.handleDeadline(at(1));
    QCOMPARE(joiner.poll()->text, kFirst + "…end");
    QCOMPARE(joiner.poll()->text, std::string("…end"));
    QCOMPARE(joiner.nextDeadline(), kNever);
}

void StatusTextTest::lateChunkIsPutInItsPlace()
{
    StatusTextJoiner joiner;
    joiner.handleChunk(at(0), 1, 4, 9, 2, "end");
    joiner.handleChunk(at(0.1), 1, 4, 9, 0, kFirst);
    joiner.handleChunk(at(0.2), 1, 4, 9, 1, kSecond);
    QCOMPARE(joiner.poll()->text, kFirst + kSecond + "end");
    QVERIFY(!joiner.poll());
}

void StatusTextTest::repeatedChunkAddsNothing()
{
    StatusTextJoiner joiner;
    for (const int time : {0, 0, 1}) {
        joiner.handleChunk(at(time * 0.5), 1, 4, 9, 0, kFirst);
        joiner.handleChunk(at(time * 0.5), 1, 4, 9, 1, "end");
    }
    QCOMPARE(joiner.poll()->text, kFirst + "end");
    QVERIFY(!joiner.poll());
    // Another text with the same id is none.
    joiner.handleChunk(at(0.6), 1, 4, 9, 0, "short");
    QCOMPARE(joiner.poll()->text, std::string("short"));
    joiner.handleDeadline(at(2));
    QVERIFY(!joiner.poll());
}

void StatusTextTest::timeoutGivesWhatIsThere()
{
    StatusTextJoiner joiner;
    joiner.handleChunk(at(0), 1, 4, 9, 0, kFirst);
    joiner.handleDeadline(at(0.999));
    QVERIFY(!joiner.poll());
    joiner.handleDeadline(at(1));
    QCOMPARE(joiner.poll()->text, kFirst + "…");
}

void StatusTextTest::textsOfSeveralSendersInterleave()
{
    StatusTextJoiner joiner;
    joiner.handleChunk(at(0), 1, 4, 7, 0, kFirst);
    joiner.handleChunk(at(0), 191, 3, 7, 0, kSecond); // the same id of another component
    joiner.handleChunk(at(0), 1, 2, 8, 0, kSecond);   // another text of the same one
    joiner.handleChunk(at(0), 191, 6, 0, 0, "short");
    QCOMPARE(joiner.poll()->text, std::string("short"));
    joiner.handleChunk(at(0.1), 1, 4, 7, 1, "autopilot");
    joiner.handleChunk(at(0.1), 191, 3, 7, 1, "companion");
    const auto first = joiner.poll(), second = joiner.poll();
    QCOMPARE(first->text, kFirst + "autopilot");
    QCOMPARE(second->text, kSecond + "companion");
    QVERIFY(first->component == 1 && second->component == 191 && second->severity == 3);
    joiner.handleDeadline(at(1));
    QCOMPARE(joiner.poll()->text, kSecond + "…");
}

void StatusTextTest::manyBeginningsAreBounded()
{
    StatusTextJoiner joiner;
    for (std::uint16_t id = 1; id <= 1000; ++id)
        joiner.handleChunk(at(0), 1, 4, id, 0, kFirst);
    std::size_t given = 0;
    while (joiner.poll())
        ++given;
    QCOMPARE(given, 1000 - StatusTextJoiner::kMostTexts);
}

void StatusTextTest::characterThatIsSplitComesOutWhole()
{
    const std::string helicopter = "\xf0\x9f\x9a\x81";
    const std::string letters(48, 'a');
    const auto json = [](const std::string &text) {
        JsonWriter writer;
        writer.value(text);
        return writer.text();
    };
    StatusTextJoiner joiner;
    joiner.handleChunk(at(0), 1, 4, 9, 0, letters + helicopter.substr(0, 2));
    joiner.handleChunk(at(0), 1, 4, 9, 1, helicopter.substr(2) + "!");
    QCOMPARE(json(joiner.poll()->text), '"' + letters + helicopter + "!\"");
    // Cut off in a text of one message, and in a long one whose next chunk was lost: one mark for each half.
    joiner.handleChunk(at(0), 1, 4, 0, 0, letters + helicopter.substr(0, 2));
    QCOMPARE(json(joiner.poll()->text), '"' + letters + "\xef\xbf\xbd\"");
    joiner.handleChunk(at(0), 1, 4, 10, 0, letters + helicopter.substr(0, 2));
    joiner.handleChunk(at(0), 1, 4, 10, 2, helicopter.substr(3) + "!");
    joiner.handleDeadline(at(1));
    QCOMPARE(json(joiner.poll()->text), '"' + letters + "\xef\xbf\xbd…\xef\xbf\xbd!\"");
}

void StatusTextTest::vehicleNumbersAndKeepsTheLast200()
{
    Harness h = Harness::copter();
    for (int i = 1; i <= 250; ++i)
        h.feed(statusText("text " + std::to_string(i), 6));
    const auto state = h.vehicle.state(h.now);
    QCOMPARE(state.texts.size(), std::size_t(200));
    QCOMPARE(state.texts.front().text, std::string("text 51"));
    QCOMPARE(state.texts.back().number, std::uint64_t(250));
}

void StatusTextTest::textsOfOtherComponentsAreHeard()
{
    Harness h = Harness::copter();
    Sender companion(1, 191);
    h.vehicle.handleFrame(h.now, {}, companion.frame(statusText("camera ready", 5)));
    QCOMPARE(h.poll<TextReceived>()->text.text, std::string("camera ready"));
    // MAVLink 1 has neither id nor chunks.
    Sender old(1, 1, 1);
    h.vehicle.handleFrame(h.now, {}, old.frame(statusText(std::string(50, 'x'), 5)));
    QCOMPARE(h.poll<TextReceived>()->text.text, std::string(50, 'x'));
}

SKYSEAL_TEST_APPLESS(StatusTextTest)
#include "status_text_test.moc"
