// Rate limit of the questions (read-only requests, question_rules.h) of one peer or client: each answer uses the downlink and
// the time of the autopilot, which the pilot needs. No I/O and no clock.
#pragma once

#include "core/channel/token_bucket.h"
#include "core/engine/common/question_rules.h"

namespace skyseal::engine {

class QuestionBudget
{
public:
    /// An answer has about 40 bytes: 7 % of a 57,600-baud radio. A mission of 100 items downloads at once.
    static constexpr double kPerSecond = 10, kAtOnce = 100;
    /// A list of 1,000 parameters has about 40 kB: seven seconds of such a radio. The second list allows for one that was lost.
    static constexpr double kListsPerSecond = 1.0 / 30, kListsAtOnce = 2;

    /// Returns false if the limit is exceeded.
    bool take(TimePoint now, std::uint32_t messageId)
    {
        if (isListRequest(messageId) && !m_lists.take(now, kListsPerSecond, kListsAtOnce))
            return false;
        return m_questions.take(now, kPerSecond, kAtOnce);
    }

private:
    channel::TokenBucket m_questions, m_lists;
};

} // namespace skyseal::engine
