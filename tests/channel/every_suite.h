// Runs a test function under each suite: rows of data, and a pair whose session has the suite of the row.
#pragma once

#include "attack.h"
#include "core/crypto/suite.h"

#include <QtTest/QTest>

namespace skyseal::test {

/// One row of a data-driven test for each suite of this machine.
inline void everySuite()
{
    QTest::addColumn<int>("suite");
    for (const auto &info : crypto::suites()) {
        if (info.id != SuiteId::None && crypto::suiteAvailable(info.id))
            QTest::newRow(info.name.data()) << static_cast<int>(info.id);
    }
}

} // namespace skyseal::test

#define PAIR_UNDER_SUITE                                                                                                       \
    QFETCH(int, suite);                                                                                                        \
    auto pairOwner = pairUnder(static_cast<SuiteId>(suite));                                                                   \
    Pair &pair = *pairOwner;                                                                                                   \
    QVERIFY(pair.bothUp());                                                                                                    \
    QCOMPARE(static_cast<int>(pair.ground().sessionInfo()->suite), suite)
