// Reasons: English for command lines, and the words that a translation finds for the same sentence and values.
#include "core/base/reason.h"
#include "core/base/result.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;

namespace {

constexpr Sentence kLate = sentence("Reason", "no answer for %1 s");
constexpr Sentence kBecause = sentence("Reason", "nothing was sent: %1");
constexpr Sentence kTwo = sentence("Reason", "%2 before %1, %2 again, %3 not at all");

std::string shout(const Sentence &sentence)
{
    if (std::string(sentence.english()) == "no answer for %1 s")
        return "%1 s ohne Antwort";
    return "<" + std::string(sentence.english()) + ">";
}

} // namespace

class ReasonTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void valuesStandInTheirPlaces()
    {
        QCOMPARE(kLate(3).text(), std::string("no answer for 3 s"));
        QCOMPARE(kBecause(kLate(std::uint8_t{200})).text(), std::string("nothing was sent: no answer for 200 s"));
        QCOMPARE(kTwo("a", std::string("b")).text(), std::string("b before a, b again, %3 not at all"));
        QCOMPARE(Reason(kLate).text(), std::string("no answer for %1 s"));
    }

    /// Of a vehicle or the system: never patterns, whatever they hold.
    void textsFromOutsideStayAsTheyAre()
    {
        QCOMPARE(Reason("100 %1").text(shout), std::string("100 %1"));
        QCOMPARE(kBecause("%1 %2").text(), std::string("nothing was sent: %1 %2"));
        QCOMPARE(kTwo("%2", "x").text(), std::string("x before %2, x again, %3 not at all"));
    }

    void everySentenceIsTranslated()
    {
        QCOMPARE(kBecause(kLate(3)).text(shout), std::string("<nothing was sent: 3 s ohne Antwort>"));
        QCOMPARE(kBecause("LOITER").text(shout), std::string("<nothing was sent: LOITER>"));
    }

    void equalWordsAreEqualReasons()
    {
        QVERIFY(kLate(3) == Reason("no answer for 3 s") && !(kLate(3) == kLate(4)));
        QVERIFY(Reason().empty() && Reason("").empty() && !kLate(3).empty());
    }

    void errorsNameTheirPlace()
    {
        const InputError error{kLate(3), "a.file", 12, 4};
        QCOMPARE(error.text(), std::string("a.file:12:4: no answer for 3 s"));
        QCOMPARE(error.reason().text(shout), std::string("<a.file:12:4: 3 s ohne Antwort>"));
        const InputError nowhere{kLate(3), {}};
        QCOMPARE(nowhere.reason().text(shout), std::string("3 s ohne Antwort"));
    }
};

SKYSEAL_TEST(ReasonTest)
#include "reason_test.moc"
