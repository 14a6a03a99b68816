// The parameters that are known of a vehicle, and when others see their changes.
#include "core/vehicle/parameter_store.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::vehicle;

class ParameterStoreTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void changesAreCollected();
    void indexSurvivesAWrite();
    void namesAreBounded();
    void componentsAreApart();
    void labelsNameThem();
};

void ParameterStoreTest::changesAreCollected()
{
    ParameterStore store;
    TimePoint now{};
    QVERIFY(!store.list());
    QVERIFY(store.store({"A", 1}));
    store.publishChange(now, false); // the first one is shown at once
    const auto first = store.list();
    QCOMPARE(first->size(), std::size_t(1));
    QVERIFY(!store.store({"A", 1}));
    QVERIFY(store.store({"A", 2}));
    store.publishChange(now, false);
    QCOMPARE(store.list(), first);
    QCOMPARE(store.publishDue(), now + ParameterStore::kCollectFor);
    store.publish(store.publishDue());
    QCOMPARE(store.list()->at(0).value, 2.);
    QCOMPARE(first->at(0).value, 1.);
    QCOMPARE(store.publishDue(), kNever);
    QVERIFY(store.store({"A", 3}));
    store.publishChange(now + ParameterStore::kCollectFor, true); // the result of a request
    QCOMPARE(store.list()->at(0).value, 3.);
}

void ParameterStoreTest::indexSurvivesAWrite()
{
    ParameterStore store;
    QVERIFY(store.store({"A", 1, mavlink::MAV_PARAM_TYPE_REAL32, 7}));
    QVERIFY(store.store({"A", 2, mavlink::MAV_PARAM_TYPE_REAL32, ParameterStore::kNoIndex}));
    QCOMPARE(int(store.find(0, "A")->index), 7);
    QVERIFY(!store.find(0, "B"));
}

void ParameterStoreTest::namesAreBounded()
{
    ParameterStore store;
    store.expect(0, 10);
    for (std::size_t i = 0; i < 10 + ParameterStore::kNamesBeyondCount; ++i)
        QVERIFY(store.store({"P" + std::to_string(i)}));
    QVERIFY(!store.store({"ONE_MORE"}));
    store.expect(0, 11);
    QVERIFY(store.store({"ONE_MORE"}));
}

void ParameterStoreTest::componentsAreApart()
{
    ParameterStore store;
    store.expect(0, 2);
    store.expect(154, 1);
    QCOMPARE(store.expected(), 3u);
    QVERIFY(store.store({.name = "A", .value = 3, .componentId = 154}));
    QVERIFY(store.store({.name = "B", .value = 2}));
    QVERIFY(store.store({.name = "A", .value = 1}));
    QCOMPARE(store.find(0, "A")->value, 1.);
    QCOMPARE(store.find(154, "A")->value, 3.);
    QVERIFY(!store.find(154, "B") && !store.find(100, "A"));
    const auto list = store.list();
    QCOMPARE(list->size(), std::size_t(3));
    QCOMPARE(parameterLabel(list->at(0)) + " " + parameterLabel(list->at(2)), std::string("A 154:A"));
    // However many names other components invent, those of the autopilot have room.
    for (int component = 2; component < 255; ++component) {
        store.expect(static_cast<std::uint8_t>(component), 60'000);
        for (int i = 0; i < 100; ++i)
            store.store({.name = "P" + std::to_string(i), .componentId = static_cast<std::uint8_t>(component)});
    }
    store.publish({});
    QCOMPARE(store.list()->size(), ParameterStore::kMostNames + 2);
    QVERIFY(store.store({.name = "C"}));
}

void ParameterStoreTest::labelsNameThem()
{
    const auto split = [](std::string_view label) {
        const ParameterName name = parameterName(label);
        return std::to_string(name.componentId) + " " + name.name;
    };
    QCOMPARE(split("RTL_ALT"), std::string("0 RTL_ALT"));
    QCOMPARE(split("154:RTL_ALT"), std::string("154 RTL_ALT"));
    QCOMPARE(split(parameterLabel({.name = "PAN", .componentId = 7})), std::string("7 PAN"));
    for (const char *odd : {"256:A", "0:A", ":A", "x:A", "1 :A"})
        QCOMPARE(split(odd), std::string("0 ") + odd);
}

SKYSEAL_TEST_APPLESS(ParameterStoreTest)
#include "parameter_store_test.moc"
