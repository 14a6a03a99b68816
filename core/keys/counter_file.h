// The counters against replayed first messages, on disk. Each number is on the disk before it is used, so that it never
// repeats after a kill or a power cut. Each change is made under a lock on the current content of the file, so that two
// programs with the same identity do not use the same numbers. Text:
//
//   skyseal-counters-v1
//   next 42                                    the next number of our own first messages
//   seen 64 hex digits (a public key) 17       the greatest number accepted from that peer
#pragma once

#include "core/base/result.h"
#include "core/channel/counter_store.h"

#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace skyseal::keys {

/// The content of the file.
struct Counters
{
    std::uint64_t next = 1;
    std::map<channel::PublicKey, std::uint64_t> seen;

    static Result<Counters, InputError> parse(std::string_view text, const std::string &source);
    std::string text() const;
};

/// Lives on the thread of its endpoint; each change costs a sync of the disk.
class FileCounterStore final : public channel::CounterStore
{
public:
    /// Creates the file if it does not exist, with `first` as its next number. Fails if the file is damaged: starting over
    /// would allow replays of old first messages.
    static Result<std::unique_ptr<FileCounterStore>, InputError> open(const std::string &path, std::uint64_t first = 1);

    std::uint64_t next() override;
    bool skipTo(std::uint64_t counter) override;
    std::uint64_t lastSeen(const channel::PublicKey &peer) override;
    bool remember(const channel::PublicKey &peer, std::uint64_t counter) override;

    /// The disk error of the last call, after which next() continues in memory only; an empty message if there was none.
    const InputError &lastError() const { return m_error; }

private:
    explicit FileCounterStore(std::string path) : m_path(std::move(path)) {}
    bool refresh();
    bool write();

    std::string m_path;
    Counters m_counters;
    InputError m_error;
};

} // namespace skyseal::keys
