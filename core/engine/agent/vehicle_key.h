// The key of MAVLink signing that the agent shares with its vehicle, and the time up to which it has signed. The key is in
// a file of 64 hex digits or 32 bytes, like that of other MAVLink tools, which no other user can read; the time is in
// FILE.time.
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/base/secret_bytes.h"
#include "core/keys/signing_time_file.h"

#include <memory>
#include <string>

namespace skyseal::engine {

struct VehicleKey
{
    Key32 key;
    std::unique_ptr<keys::SigningTimeFile> times; ///< null: the time starts at 0 and is not stored
};

/// Fails like keys::readFile() for private files, if the content is not a key, and for a key of zeros, which means "no key".
Result<VehicleKey, InputError> readVehicleKey(const std::string &path);
/// Creates a key that only its owner can read (0600). Fails if the file exists.
Result<void, InputError> writeNewVehicleKey(const std::string &path, RandomSource &random);

inline std::string signingTimeFile(const std::string &keyFile)
{
    return keyFile + ".time";
}

} // namespace skyseal::engine
