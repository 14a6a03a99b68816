#include "core/channel/suite_strength.h"

#include <algorithm>
#include <iterator>

namespace skyseal::channel {

int strengthOf(crypto::SuiteId suite)
{
    switch (suite) {
    case crypto::SuiteId::ChaCha20Poly1305:
    case crypto::SuiteId::Aes256Gcm: return 4;
    case crypto::SuiteId::Aes256Ctr:
    case crypto::SuiteId::ChaCha20: return 3;
    case crypto::SuiteId::Aes256Cbc: return 2;
    case crypto::SuiteId::Rc4: return 1;
    case crypto::SuiteId::None: break;
    }
    return 0;
}

std::vector<crypto::SuiteId> notWeakerThan(crypto::SuiteId weakest, const std::vector<crypto::SuiteId> &suites)
{
    std::vector<crypto::SuiteId> out;
    std::copy_if(suites.begin(), suites.end(), std::back_inserter(out),
                 [weakest](crypto::SuiteId suite) { return strengthOf(suite) >= strengthOf(weakest); });
    return out;
}

} // namespace skyseal::channel
