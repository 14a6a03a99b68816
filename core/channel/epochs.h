// The live epochs of one session: previous, current, next, and nothing else. What an epoch counted outlives its keys.
#pragma once

#include "core/base/clock.h"
#include "core/channel/replay_window.h"
#include "core/channel/stats.h"
#include "core/crypto/inline_cipher.h"
#include "core/crypto/record_cipher.h"

#include <deque>
#include <memory>
#include <optional>

namespace skyseal::channel {

/// One epoch with its keys. A next epoch has a writer that is not used yet, a previous one has none any more.
struct LiveEpoch
{
    Epoch number{};
    crypto::SuiteId suite{};
    std::unique_ptr<crypto::RecordCipher> reader;
    std::unique_ptr<crypto::RecordCipher> writer;
    /// For frames sealed in place; null unless both ends allow it and the suite can do it. Keys of their own, but counter
    /// and window are those of the records: one account of what is missing.
    std::unique_ptr<crypto::InlineCipher> inlineReader;
    std::unique_ptr<crypto::InlineCipher> inlineWriter;
    ReplayWindow window;
    std::uint32_t sent = 0; ///< records and frames sealed under it = the counter of the next one
    ReceiveCounters rx;     ///< `lost` is not kept here, the window knows it
    SendCounters tx;

    EpochStats stats() const;
};

class Epochs
{
public:
    bool begun() const { return m_current != nullptr; }
    /// Precondition of this and of all sums: the first epoch was prepared, and `advance` called.
    LiveEpoch &current() { return *m_current; }
    const LiveEpoch &current() const { return *m_current; }
    LiveEpoch *previous() { return m_previous.get(); }
    const LiveEpoch *previous() const { return m_previous.get(); }
    bool hasNext() const { return m_next != nullptr; }
    /// The live epoch with these low bits; nullptr when its keys are gone or were never there.
    LiveEpoch *byBits(std::uint8_t bits);
    /// The same by the low byte of its number, as frames sealed in place carry it.
    LiveEpoch *byLowByte(std::uint8_t lowByte);
    bool isNext(const LiveEpoch &epoch) const { return &epoch == m_next.get(); }

    void prepareNext(LiveEpoch next) { m_next = std::make_unique<LiveEpoch>(std::move(next)); }
    void dropNext() { m_next.reset(); }
    /// next becomes current, current previous; the old previous dies, and the writer of the new one with it.
    void advance();
    void retirePrevious();
    /// The peer says how many records it sealed under the epoch before the current one.
    void expectBeforeCurrent(std::uint32_t records);

    /// Sums over the whole session, and the newest epochs one by one.
    ReceiveCounters received() const;
    SendCounters sent() const;
    std::vector<EpochStats> history() const;

private:
    struct Retired
    {
        EpochStats stats;
        ReplayWindow window;
    };

    std::unique_ptr<LiveEpoch> m_previous;
    std::unique_ptr<LiveEpoch> m_current;
    std::unique_ptr<LiveEpoch> m_next;
    std::optional<Retired> m_last; ///< the last that was retired: its loss may still be learned
    std::deque<EpochStats> m_history;
    ReceiveCounters m_receivedBefore; ///< sums of all retired epochs but the last
    SendCounters m_sentBefore;
};

} // namespace skyseal::channel
