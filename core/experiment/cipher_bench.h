// What sealing and opening cost per suite and payload size, in this process and without a network: the cipher alone, cipher
// and authentication, the complete record of a session, each beside the bare library calls in the same rounds; and the memory
// that a context and a session take.
#pragma once

#include "core/crypto/suite.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::experiment {

/// Nanoseconds of one call. `best` is the least disturbed round, `median` the usual one; the two far apart mean a busy machine.
struct CallCost
{
    double best = 0, median = 0;
};

/// One direction.
struct StepCosts
{
    CallCost cipher; ///< without authentication, the library's call
    CallCost bare;   ///< cipher and authentication, the library's calls
    CallCost suite;  ///< cipher and authentication, the suite's object
    CallCost record; ///< the complete record through a session: look-up, header, counters, replay window
};

struct SizeCosts
{
    std::size_t size = 0; ///< bytes of plaintext
    StepCosts seal, open;
};

struct SuiteCosts
{
    crypto::SuiteId suite{};
    std::vector<SizeCosts> sizes;
    std::optional<double> contextBytes; ///< heap of one direction's cipher, keyed
    std::optional<double> sessionBytes; ///< heap of one end's session, its ciphers included
    bool failed = false;                ///< a record did not open: the figures are void
};

/// Some tenths of a second for each size. `sizes` at most 1100.
SuiteCosts benchSuite(crypto::SuiteId suite, const std::vector<std::size_t> &sizes);

/// Heap of one direction's keyed cipher; nullopt where the suite is not available, or the C library does not tell.
std::optional<double> contextBytes(crypto::SuiteId suite);

/// The same of one end's session under this suite, its ciphers included; frames sealed in place would need two more.
std::optional<double> sessionBytes(crypto::SuiteId suite);

/// One JSON object for each size, {"event":"bench",…}; `aes` is whether AES instructions were used.
std::vector<std::string> benchEvents(const SuiteCosts &costs, bool aes);
/// A table for people; the first line of all is benchHeader().
std::vector<std::string> benchText(const SuiteCosts &costs);
std::vector<std::string> benchHeader();

} // namespace skyseal::experiment
