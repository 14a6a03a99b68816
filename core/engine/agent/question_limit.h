// Rate limit of the questions (read-only requests) of each observer. Counted for each key, so that reconnecting does not raise
// the limit. No I/O and no clock.
#pragma once

#include "core/channel/policy.h"
#include "core/engine/common/question_budget.h"

#include <algorithm>
#include <map>
#include <vector>

namespace skyseal::engine {

class QuestionLimit
{
public:
    /// Forgets all peers that are not listed.
    void setPeers(const std::vector<channel::Peer> &peers)
    {
        std::erase_if(m_budgets, [&peers](const auto &entry) {
            return std::none_of(peers.begin(), peers.end(), [&](const auto &peer) { return peer.key == entry.first; });
        });
    }

    /// Returns false if the peer exceeds its limit.
    bool take(TimePoint now, const channel::PublicKey &peer, const mavlink::Frame &question)
    {
        return m_budgets[peer].take(now, question.messageId());
    }

private:
    std::map<channel::PublicKey, QuestionBudget> m_budgets;
};

} // namespace skyseal::engine
