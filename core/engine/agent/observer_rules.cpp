#include "core/engine/agent/observer_rules.h"

#include "core/engine/common/misreading.h"
#include "core/engine/common/question_rules.h"

namespace skyseal::engine {

bool observerMaySend(const mavlink::Frame &frame, bool pilotThere)
{
    return isPlainlySaid(frame) && isHarmlessQuestion(frame, !pilotThere);
}

} // namespace skyseal::engine
