// The counters against replayed first messages, on disk. Text:
//
//   skyseal-counters-v1
//   next 1025                                  no program uses a number from here on before it has raised this line
//   seen 64 hex digits (a public key) 17       the greatest number accepted from that peer
//
// Our own numbers are reserved in blocks of 1,024: a block is on the disk before its first number is used, so that none
// repeats after a kill or a power cut, and a restart skips the rest of the block. Each change is made under a lock on the
// current content of the file, so that two programs with the same identity do not use the same numbers. (PROTOCOL.md,
// section 4.)
//
// The endpoint's thread never waits for the disk, since senders that are not authenticated make it use numbers: a thread of
// the store reserves the next block when half of the present one is used, and stores accepted numbers after the fact. Where
// the disk is full, read-only or does not answer, the store goes on in memory, says so (problem()) and tries again.
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/channel/counter_store.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace skyseal::keys {

/// The content of the file.
struct StoredCounters
{
    std::uint64_t next = 1;
    std::map<channel::PublicKey, std::uint64_t> seen;

    static Result<StoredCounters, InputError> parse(std::string_view text, const std::string &source);
    std::string text() const;
};

/// Access to the file, and the clock that bounds how long it may take.
struct CounterDisk
{
    /// Merges `ours` into the content, reserves `reserve` numbers and returns the result. `create`: the file need not exist.
    std::function<Result<StoredCounters, InputError>(StoredCounters ours, std::uint64_t reserve, bool create)> update;
    std::function<Result<StoredCounters, InputError>()> read;
    /// Whether there is no file yet, in a folder that exists.
    std::function<bool()> isMissing;
    std::function<TimePoint()> now;
    std::string name; ///< in errors
};
CounterDisk counterDisk(const std::string &path);

/// Used by one thread, that of its endpoint. Only the store's own thread touches the disk.
class FileCounterStore final : public channel::CounterStore
{
public:
    /// Numbers that are reserved at a time.
    static constexpr std::uint64_t kBlock = 1024;
    /// After a failure; also what is missing then is tried again.
    static constexpr Duration kRetryAfter = std::chrono::seconds(10);
    /// A disk that takes longer counts as failed. Longer than FileLock::kPatience.
    static constexpr Duration kSlow = std::chrono::seconds(5);

    /// Creates the file if it does not exist, with `first` as its next number, and reserves the first block. Fails if the file
    /// is damaged (starting over would allow replays of old first messages), has no folder, or is not read within kSlow. A
    /// sound file that cannot be written is used as it is, and a missing one that cannot be created is made up in memory: an
    /// agent must come up again on a disk that is full or became read-only.
    static Result<std::unique_ptr<FileCounterStore>, InputError> open(const std::string &path, std::uint64_t first = 1);
    static Result<std::unique_ptr<FileCounterStore>, InputError> open(CounterDisk disk, std::uint64_t first = 1);
    /// Waits until all accepted numbers are stored, or cannot be, or the disk has not answered for kSlow.
    ~FileCounterStore() override;

    /// Nullopt until the next block is stored. Where that fails or takes longer than kSlow, numbers that are not stored are
    /// used: if one repeats, the peer just rejects the message.
    std::optional<std::uint64_t> next() override;
    bool skipTo(std::uint64_t counter) override;
    std::uint64_t lastSeen(const channel::PublicKey &peer) override;
    /// Returns true at once; the number is stored soon afterwards. A kill in between allows one more answer to an old first
    /// message, which comes to nothing, since only its true sender can confirm it.
    bool remember(const channel::PublicKey &peer, std::uint64_t counter) override;
    Reason problem() const override;

    /// Waits until the store's thread has nothing to do, and returns the error of its last write; an empty message if it
    /// succeeded.
    InputError waitUntilStored();

private:
    class Shared;

    explicit FileCounterStore(std::shared_ptr<Shared> shared) : m_shared(std::move(shared)) {}

    std::shared_ptr<Shared> m_shared; ///< with the store's thread, which outlives the store if the disk does not answer
};

} // namespace skyseal::keys
