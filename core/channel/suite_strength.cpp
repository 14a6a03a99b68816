#include "core/channel/suite_strength.h"

#include <algorithm>
#include <iterator>

namespace skyseal::channel {

std::vector<crypto::SuiteId> notWeakerThan(crypto::SuiteId weakest, const std::vector<crypto::SuiteId> &suites)
{
    std::vector<crypto::SuiteId> out;
    std::copy_if(suites.begin(), suites.end(), std::back_inserter(out),
                 [least = crypto::suiteInfo(weakest).strength](crypto::SuiteId suite) {
                     return crypto::suiteInfo(suite).strength >= least;
                 });
    return out;
}

} // namespace skyseal::channel
