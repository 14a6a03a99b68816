// Tools of others that our own figures are held against: perf, heaptrack. A test that needs one says so and is skipped where
// it is not there.
#pragma once

#include "tests/support/run_program.h"

#include <QtCore/QStandardPaths>

namespace skyseal::test {

/// Run it by runToItsEnd().
inline bool hasTool(const char *name)
{
    return !QStandardPaths::findExecutable(QString::fromLatin1(name)).isEmpty();
}

} // namespace skyseal::test
