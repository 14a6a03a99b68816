// The time line of a replay for screen readers: a slider whose value is said as a time. It counts milliseconds otherwise.
#pragma once

namespace skyseal::ui {

/// Call before the first time line is made; later calls have no effect.
void installTimelineAccess();

} // namespace skyseal::ui
