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
    QCOMPARE(int(store.find("A")->index), 7);
    QVERIFY(!store.find("B"));
}

void ParameterStoreTest::namesAreBounded()
{
    ParameterStore store;
    store.expect(10);
    for (std::size_t i = 0; i < 10 + ParameterStore::kNamesBeyondCount; ++i)
        QVERIFY(store.store({"P" + std::to_string(i)}));
    QVERIFY(!store.store({"ONE_MORE"}));
    store.expect(11);
    QVERIFY(store.store({"ONE_MORE"}));
}

SKYSEAL_TEST_APPLESS(ParameterStoreTest)
#include "parameter_store_test.moc"
