// The time up to which frames were signed with one key, on disk: a signer that starts again must not use a time twice, and
// there may be no clock. Text:
//
//   skyseal-signing-time-v1
//   1234567                      units of 10 µs (core/mavlink/signing.h)
//
// The caller stores times ahead of need. A thread of the file's own writes, since the thread that signs must not wait for a
// disk; where the disk fails, it says so (problem()) and tries again. A lost time does no lasting harm: the signer continues
// from the times in the vehicle's signed frames.
#pragma once

#include "core/base/result.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace skyseal::keys {

/// Safe for any bytes; `source` names the text in errors.
Result<std::uint64_t, InputError> parseSigningTime(std::string_view text, const std::string &source);
std::string signingTimeText(std::uint64_t time);

/// Used by one thread.
class SigningTimeFile
{
public:
    using Write = std::function<Result<void, InputError>(std::uint64_t time)>;

    /// After a failure, and for the end to wait for a disk that does not answer.
    static constexpr std::chrono::seconds kRetryAfter{10};
    static constexpr std::chrono::seconds kPatience{5};

    /// A file that does not exist yet stands for 0. Fails if the file is damaged or other users can change it: old frames of
    /// the vehicle would count as new.
    static Result<std::unique_ptr<SigningTimeFile>, InputError> open(const std::string &path);
    /// `write` is called on the other thread, and must own all that it uses. `name` stands in errors.
    SigningTimeFile(std::uint64_t stored, Write write, std::string name);
    /// Waits until the last time is stored, or cannot be, or kPatience is over.
    ~SigningTimeFile();

    /// The time in the file when it was opened.
    std::uint64_t storedAtStart() const { return m_storedAtStart; }
    /// Stores a time soon; returns at once. Lesser ones than before have no effect.
    void store(std::uint64_t time);
    /// Why the last time is not stored; empty if it is, or will be in a moment.
    std::string problem() const;

private:
    class Writer;

    const std::uint64_t m_storedAtStart;
    std::shared_ptr<Writer> m_writer; ///< with a thread that outlives this object if the disk does not answer
};

} // namespace skyseal::keys
