// The list of suite numbers in an offer: every list that fits survives, and every content of the field is readable.
#include "core/channel/suite_list.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>

using namespace skyseal;
using namespace skyseal::channel;

using Numbers = std::vector<std::uint8_t>;

class SuiteListTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listsThatFitSurvive();
    void longestListsSurvive();
    void listsThatDoNotFitAreCut();
    void everyFieldIsReadable();
    void zerosAndRepetitionsAreSkipped();
    void longFormIsReadStrictly();
};

namespace {

std::size_t halvesOf(const Numbers &numbers)
{
    return std::accumulate(numbers.begin(), numbers.end(), std::size_t(0),
                           [](std::size_t sum, std::uint8_t number) { return sum + suiteNumberHalves(number); });
}

/// The field with these half bytes.
SuiteListField fieldOf(const std::array<unsigned, kSuiteListHalves> &halves)
{
    SuiteListField field{};
    for (std::size_t i = 0; i < field.size(); ++i)
        field[i] = static_cast<std::uint8_t>(halves[2 * i] | halves[2 * i + 1] << 4);
    return field;
}

} // namespace

void SuiteListTest::listsThatFitSurvive()
{
    QVERIFY(rc::check([] {
        auto numbers = *rc::gen::unique<Numbers>(rc::gen::inRange<std::uint8_t>(1, 255));
        while (halvesOf(numbers) > kSuiteListHalves)
            numbers.pop_back();
        const auto field = packSuiteNumbers(numbers);
        RC_ASSERT(unpackSuiteNumbers(field) == numbers);
    }));
}

void SuiteListTest::longestListsSurvive()
{
    for (const Numbers &numbers :
         {Numbers{12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1}, Numbers{255, 15, 16, 240}, Numbers{255, 2, 3, 128, 4, 15}}) {
        const auto field = packSuiteNumbers(numbers);
        QCOMPARE(unpackSuiteNumbers(field), numbers);
    }
}

void SuiteListTest::listsThatDoNotFitAreCut()
{
    const auto carried = [](const Numbers &numbers) { return unpackSuiteNumbers(packSuiteNumbers(numbers)); };
    const Numbers twelve{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    QCOMPARE(carried({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13}), twelve);
    QCOMPARE(carried({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 200}), twelve);
    QCOMPARE(carried({15, 16, 17, 18, 1}), (Numbers{15, 16, 17, 18}));
    // No number behind the first one that does not fit, even if there is room for it.
    QCOMPARE(carried({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 15, 11}), (Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
}

void SuiteListTest::everyFieldIsReadable()
{
    QVERIFY(rc::check([] {
        const auto field = *rc::gen::arbitrary<SuiteListField>();
        const Numbers numbers = unpackSuiteNumbers(field);
        RC_ASSERT(std::find(numbers.begin(), numbers.end(), 0) == numbers.end());
        RC_ASSERT(halvesOf(numbers) <= kSuiteListHalves);
        const auto again = packSuiteNumbers(numbers);
        RC_ASSERT(unpackSuiteNumbers(again) == numbers);
    }));
}

void SuiteListTest::zerosAndRepetitionsAreSkipped()
{
    QCOMPARE(unpackSuiteNumbers(SuiteListField{}), Numbers());
    QCOMPARE(unpackSuiteNumbers(fieldOf({0, 3, 0, 3, 1, 0, 15, 0, 2, 3, 1, 2})), (Numbers{3, 1, 32, 2}));
    QCOMPARE(unpackSuiteNumbers(fieldOf({15, 7, 2, 15, 7, 2, 0, 0, 0, 0, 0, 5})), (Numbers{39, 5}));
}

void SuiteListTest::longFormIsReadStrictly()
{
    QCOMPARE(unpackSuiteNumbers(fieldOf({15, 2, 0, 1, 15, 0, 0, 15, 14, 0, 3, 0})), (Numbers{1, 3})); // 2, 0 and 14
    QCOMPARE(unpackSuiteNumbers(fieldOf({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 15, 3})), Numbers{1});         // cut off
    QCOMPARE(unpackSuiteNumbers(fieldOf({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 15})), Numbers{1});
    QCOMPARE(unpackSuiteNumbers(fieldOf({0, 0, 0, 0, 0, 0, 0, 0, 0, 15, 15, 0})), Numbers{15});
}

SKYSEAL_TEST(SuiteListTest)
#include "suite_list_test.moc"
