// Self-test of a program on the machine where it runs, within a second: every cipher, the handshake and the MAVLink code must
// give known answers, and two endpoints in this process must establish a session. It detects a wrong library or processor flag
// before the flight.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::engine {

struct SelfTest
{
    std::string name;
    /// The problem; nullopt if the test passed.
    std::function<std::optional<std::string>()> run;
};

/// In the order of the layers: the first failure is likely the cause of later ones. Call crypto::initCrypto() first.
std::vector<SelfTest> selfTests();

// The tests of the single layers, which selfTests() combines.
std::vector<SelfTest> primitiveSelfTests();
std::vector<SelfTest> suiteSelfTests();
std::vector<SelfTest> handshakeSelfTests();
std::vector<SelfTest> mavlinkSelfTests();
std::vector<SelfTest> sessionSelfTests();

} // namespace skyseal::engine
