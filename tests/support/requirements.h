// What some tests need and a machine may lack: programs, implementations and data of others, rights. A test function, or
// initTestCase() for all of its class, begins with SKYSEAL_REQUIRES("name"), and its ctest entry is declared with REQUIRES or
// APART (cmake/SkysealTargets.cmake). ctest runs the entry requires_NAME before it, so that its summary names what is missing.
#pragma once

#include <QtTest/QTest>

#include <span>
#include <string_view>

namespace skyseal::test {

struct Requirement
{
    const char *name;
    /// packaging/dependencies or ./test installs it, or any machine has it. In continuous integration its lack is a failure.
    bool isInContinuousIntegration;
    bool (*isMet)();
    const char *lack; ///< what is missing, and the variable that names it or the package that holds it
};

std::span<const Requirement> requirements();

/// What is missing; null if the requirement is met. Ends the program for a name that no row of requirements() has.
const char *lackOf(std::string_view requirement);

/// Whether lackOf() has found something missing in this process.
bool isSomethingMissing();

/// The interpreter that has the module cryptography: Debian's, or the one that SKYSEAL_PYTHON names.
QString pythonProgram();

/// The full facts of MAVLink's messages: the folder that SKYSEAL_MAVLINK_FACTS names, or else the one beside the source tree.
QString mavlinkFactsFolder();

/// Vector files that are too large for the repository: the folder that SKYSEAL_VECTORS names, or else the one beside the source
/// tree; empty if neither is there.
QString publishedVectorsFolder();

} // namespace skyseal::test

/// Skips the test function, or the class in initTestCase(), unless the requirement is met.
#define SKYSEAL_REQUIRES(requirement)                                                                                          \
    do {                                                                                                                       \
        if (const char *const lack = ::skyseal::test::lackOf(requirement))                                                     \
            QSKIP(lack);                                                                                                       \
    } while (false)
