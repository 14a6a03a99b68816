// The check that attack tests and the proofs share.
#pragma once

#include <QtTest/QTest>

/// Verifies that an attack has no effect. `text` names the check: tests/weakened/proofs.h expects it to fail unprotected.
#define HOLDS(condition, text) QVERIFY2(condition, text)
