// How often the questions of a peer that may only ask reach the vehicle: each answer uses the downlink and the autopilot's
// time, which are the pilot's. Counted for each key, so that reconnecting brings no further questions. No I/O and no clock.
#pragma once

#include "core/channel/policy.h"
#include "core/channel/token_bucket.h"
#include "core/engine/agent/observer_rules.h"

#include <algorithm>
#include <map>
#include <vector>

namespace skyseal::engine {

class QuestionLimit
{
public:
    /// An answer has about 40 bytes: 7 % of a 57,600-baud radio. A mission of 100 items downloads at once.
    static constexpr double kPerSecond = 10, kAtOnce = 100;
    /// A list of 1,000 parameters has about 40 kB: seven seconds of such a radio. The second one is for a list that was lost.
    static constexpr double kListsPerSecond = 1.0 / 30, kListsAtOnce = 2;

    /// Forgets all peers that are not listed.
    void setPeers(const std::vector<channel::Peer> &peers)
    {
        std::erase_if(m_buckets, [&peers](const auto &entry) {
            return std::none_of(peers.begin(), peers.end(), [&](const auto &peer) { return peer.key == entry.first; });
        });
    }

    /// Returns false if the peer asks too often.
    bool take(TimePoint now, const channel::PublicKey &peer, const mavlink::Frame &question)
    {
        Buckets &buckets = m_buckets[peer];
        if (isListRequest(question.messageId()) && !buckets.lists.take(now, kListsPerSecond, kListsAtOnce))
            return false;
        return buckets.questions.take(now, kPerSecond, kAtOnce);
    }

private:
    struct Buckets
    {
        channel::TokenBucket questions, lists;
    };
    std::map<channel::PublicKey, Buckets> m_buckets;
};

} // namespace skyseal::engine
