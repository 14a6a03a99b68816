#include "core/channel/negotiation.h"

#include "core/base/research.h"
#include "core/channel/suite_list.h"

#include <algorithm>

namespace skyseal::channel {

using crypto::SuiteId;

namespace {

bool isResearch(SuiteId suite)
{
    return crypto::suiteInfo(suite).research;
}

} // namespace

bool holds(const std::vector<SuiteId> &suites, SuiteId wanted)
{
    return std::find(suites.begin(), suites.end(), wanted) != suites.end();
}

std::vector<SuiteId> defaultSuites()
{
    return crypto::sealedSuites();
}

SuiteOffer offerOf(const Policy &policy)
{
    SuiteOffer offer;
    if constexpr (kResearch)
        offer = {{}, policy.allowResearch, policy.allowPlain, policy.allowInline, policy.allowInline && policy.preferInline};
    std::size_t halves = 0;
    for (const SuiteId suite : policy.suites) {
        const bool wanted = suite != SuiteId::None && (offer.allowResearch || !isResearch(suite));
        if (!wanted || holds(offer.suites, suite))
            continue;
        halves += suiteNumberHalves(static_cast<std::uint8_t>(suite));
        if (halves > kSuiteListHalves)
            break; // Cut here and not on the wire: both ends must choose from the same lists.
        offer.suites.push_back(suite);
    }
    return offer;
}

bool inlineWanted(const SuiteOffer &one, const SuiteOffer &other)
{
    return one.allowInline && other.allowInline && (one.preferInline || other.preferInline);
}

std::vector<SuiteId> permittedSuites(const SuiteOffer &initiator, const SuiteOffer &responder)
{
    std::vector<SuiteId> both;
    const bool research = initiator.allowResearch && responder.allowResearch;
    for (const SuiteId suite : initiator.suites) {
        if (suite != SuiteId::None && (research || !isResearch(suite)) && holds(responder.suites, suite))
            both.push_back(suite);
    }
    if (initiator.allowPlain && responder.allowPlain)
        both.push_back(SuiteId::None);
    return both;
}

std::optional<SuiteId> chooseSuite(const SuiteOffer &initiator, const SuiteOffer &responder)
{
    for (const SuiteId suite : permittedSuites(initiator, responder)) {
        if (suite != SuiteId::None && !isResearch(suite))
            return suite;
    }
    return std::nullopt;
}

} // namespace skyseal::channel
