// What the tests of attacks say of each one.
#pragma once

#include <QtTest/QTest>

/// The check that an attack comes to nothing. Its words name it: the proofs ask for the very check that fails.
#define HOLDS(condition, words) QVERIFY2(condition, words)
