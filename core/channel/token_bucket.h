// Token bucket: a burst of `atOnce` tokens, refilled at `perSecond`.
#pragma once

#include "core/base/clock.h"

#include <algorithm>

namespace skyseal::channel {

struct TokenBucket
{
    double credit = 0;
    TimePoint at = TimePoint::min(); ///< before the first use, when the bucket is full

    void fill(TimePoint now, double perSecond, double atOnce)
    {
        credit = at == TimePoint::min() ? atOnce : std::min(atOnce, credit + seconds(now - at) * perSecond);
        at = now;
    }
    bool take(TimePoint now, double perSecond, double atOnce)
    {
        fill(now, perSecond, atOnce);
        if (credit < 1)
            return false;
        credit -= 1;
        return true;
    }
};

} // namespace skyseal::channel
