// What a program can check of itself on the machine it runs on, in a second: that every cipher, the handshake and the
// MAVLink code give the known answers, and that two ends inside this process agree on a session. A wrong library or
// processor flag shows here, before it shows in flight.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::engine {

struct SelfTest
{
    std::string name;
    /// What is wrong; nullopt when all is well.
    std::function<std::optional<std::string>()> run;
};

/// In the order of the layers: what fails first is likely the cause of what fails after it. Call crypto::initCrypto() first.
std::vector<SelfTest> selfTests();

// The layers' own, joined by selfTests().
std::vector<SelfTest> primitiveSelfTests();
std::vector<SelfTest> suiteSelfTests();
std::vector<SelfTest> handshakeSelfTests();
std::vector<SelfTest> mavlinkSelfTests();
std::vector<SelfTest> sessionSelfTests();

} // namespace skyseal::engine
