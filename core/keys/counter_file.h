// The counters that make an old first message worthless, on disk. Each number is on the disk before it is used, so that no
// kill and no power cut makes one come twice; and each change is made under a lock on what the file then holds, so that two
// programs of one identity do not count over each other. Text:
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

/// What the file holds.
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
    /// A file that does not exist is created, with `first` as its next number. Refused when it is damaged: starting over
    /// would let old first messages in again.
    static Result<std::unique_ptr<FileCounterStore>, InputError> open(const std::string &path, std::uint64_t first = 1);

    std::uint64_t next() override;
    bool skipTo(std::uint64_t counter) override;
    std::uint64_t lastSeen(const channel::PublicKey &peer) override;
    bool remember(const channel::PublicKey &peer, std::uint64_t counter) override;

    /// What the last call met with when the disk failed it; `next` then went on in memory alone. Empty message = nothing.
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
