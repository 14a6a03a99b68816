// The live epochs of one session, at most previous, current and next, and the key chain from which the next one is derived
// (PROTOCOL.md, sections 5 and 8). The counters of an epoch outlive its keys.
#pragma once

#include "core/base/clock.h"
#include "core/channel/key_chain.h"
#include "core/channel/recent_tags.h"
#include "core/channel/replay_window.h"
#include "core/channel/stats.h"
#include "core/crypto/inline_cipher.h"
#include "core/crypto/record_cipher.h"

#include <deque>
#include <memory>
#include <optional>

namespace skyseal::channel {

/// One epoch with its keys. The writer of the next epoch is not used yet; the previous epoch has none.
struct LiveEpoch
{
    Epoch number{};
    crypto::SuiteId suite{};
    std::unique_ptr<crypto::RecordCipher> reader;
    std::unique_ptr<crypto::RecordCipher> writer;
    /// For inline framing; null unless both ends agreed to it and the suite has it. The keys differ from those of the records;
    /// counter and window are shared, so that one counter accounts for all losses.
    std::unique_ptr<crypto::InlineCipher> inlineReader;
    std::unique_ptr<crypto::InlineCipher> inlineWriter;
    ReplayWindow window;
    RecentTags tags;        ///< of the received records
    std::uint32_t sent = 0; ///< records and inline frames sealed so far; the counter of the next one
    ReceiveCounters rx;     ///< without `lost`, which the window computes
    SendCounters tx;

    EpochStats stats() const;
};

class Epochs
{
public:
    /// `chain`: for epoch 0. `initiator`: this end is Noise's initiator. `withInline`: make the keys of inline framing too.
    Epochs(KeyChain chain, bool initiator, bool withInline)
        : m_chain(std::move(chain)), m_initiator(initiator), m_withInline(withInline)
    {}

    bool begun() const { return m_current != nullptr; }
    /// Precondition of this and of all sums: begun().
    LiveEpoch &current() { return *m_current; }
    const LiveEpoch &current() const { return *m_current; }
    LiveEpoch *previous() { return m_previous.get(); }
    const LiveEpoch *previous() const { return m_previous.get(); }
    /// Returns the live epoch with these two low bits, nullptr if there are no keys for it.
    LiveEpoch *byBits(std::uint8_t bits)
    {
        const auto matches = [bits](const std::unique_ptr<LiveEpoch> &epoch) {
            return epoch && (static_cast<std::uint32_t>(epoch->number) & 3) == bits;
        };
        if (matches(m_current))
            return m_current.get();
        if (matches(m_previous))
            return m_previous.get();
        return matches(m_next) ? m_next.get() : nullptr;
    }
    /// The same by the low byte of the number, which inline frames carry.
    LiveEpoch *byLowByte(std::uint8_t lowByte);
    bool isNext(const LiveEpoch &epoch) const { return &epoch == m_next.get(); }

    /// Begins epoch 0. Without effect if this machine lacks the cipher.
    void begin(crypto::SuiteId suite);
    /// Derives the keys of the epoch after the current one, in place of one prepared before. Returns false, and changes
    /// nothing, if this machine lacks the cipher.
    bool prepareNext(crypto::SuiteId suite, const SwitchSecret &exchanged);
    void dropNext();
    /// The next epoch becomes the current one and the current one the previous; wipes the keys of the former previous one.
    /// Precondition: prepareNext() succeeded.
    void advance();
    void retirePrevious();
    /// The peer reported how many records it sealed under the epoch before the current one.
    void expectBeforeCurrent(std::uint32_t records);

    /// No record of the live epochs is missing so far.
    bool nothingMissing() const;
    /// Sums over the whole session, and the latest epochs one by one.
    ReceiveCounters received() const;
    SendCounters sent() const;
    std::vector<EpochStats> history() const;

private:
    bool install(Epoch number, crypto::SuiteId suite, EpochSecrets secrets);

    struct Retired
    {
        EpochStats stats;
        ReplayWindow window;
    };

    KeyChain m_chain; ///< for the epoch after the current one
    std::optional<KeyChain> m_chainAfterNext;
    bool m_initiator;
    bool m_withInline;
    std::unique_ptr<LiveEpoch> m_previous;
    std::unique_ptr<LiveEpoch> m_current;
    std::unique_ptr<LiveEpoch> m_next;
    std::optional<Retired> m_last; ///< the latest retired epoch, whose final loss may still become known
    std::deque<EpochStats> m_history;
    ReceiveCounters m_receivedBefore; ///< sums of all retired epochs except the latest
    SendCounters m_sentBefore;
};

} // namespace skyseal::channel
