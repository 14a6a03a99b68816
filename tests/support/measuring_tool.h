// External tools that verify our own figures: perf, heaptrack. A test that needs one is skipped, with that reason, if it is
// not installed.
#pragma once

#include "tests/support/run_program.h"

#include <QtCore/QStandardPaths>

namespace skyseal::test {

/// Run the tool with runToItsEnd().
inline bool hasTool(const char *name)
{
    return !QStandardPaths::findExecutable(QString::fromLatin1(name)).isEmpty();
}

} // namespace skyseal::test
