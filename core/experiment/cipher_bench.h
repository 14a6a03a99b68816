// Measures sealing and opening per suite and payload size, in process and without a network: the cipher alone, cipher and
// authentication, and the complete record of a session, each next to the bare library calls in the same rounds; also the
// memory of a context and of a session.
#pragma once

#include "core/crypto/suite.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::experiment {

/// Nanoseconds of one call. `best` is the fastest round, `median` the median one; a large difference indicates a busy machine.
struct CallCost
{
    double best = 0, median = 0;
};

/// One direction.
struct StepCosts
{
    CallCost cipher; ///< library call, without authentication
    CallCost bare;   ///< library calls, cipher and authentication
    CallCost suite;  ///< the suite's RecordCipher
    CallCost record; ///< the complete record in a session: look-up, header, counters, replay window
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
    bool failed = false;                ///< a record did not open; the figures are invalid
};

/// Takes some tenths of a second for each size; each size is at most 1100 bytes.
SuiteCosts benchSuite(crypto::SuiteId suite, const std::vector<std::size_t> &sizes);

/// Heap bytes of one direction's keyed cipher; nullopt if the suite is not available or the C library has no heap statistics.
std::optional<double> contextBytes(crypto::SuiteId suite);

/// Heap bytes of one end's session under this suite, including its ciphers but not the two for frames sealed in place.
std::optional<double> sessionBytes(crypto::SuiteId suite);

/// One JSON object for each size, {"event":"bench",…}; `aes`: AES instructions were used.
std::vector<std::string> benchEvents(const SuiteCosts &costs, bool aes);
/// Rows of the table for humans, below benchHeader().
std::vector<std::string> benchText(const SuiteCosts &costs);
std::vector<std::string> benchHeader();

} // namespace skyseal::experiment
