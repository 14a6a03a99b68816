#include "core/vehicle/pre_arm_reasons.h"

#include <algorithm>

namespace skyseal::vehicle {

namespace {

constexpr std::string_view kPrefixes[] = {"PreArm: ", "Arm: ", "Preflight Fail: ", "Arming denied: "};

/// Empty if the text is not about arming.
std::string_view reasonIn(std::string_view text)
{
    for (const std::string_view prefix : kPrefixes) {
        if (text.starts_with(prefix))
            return text.substr(prefix.size());
    }
    return {};
}

} // namespace

void PreArmReasons::handleText(TimePoint now, std::string_view text)
{
    const std::string_view reason = reasonIn(text);
    if (reason.empty())
        return;
    std::erase_if(m_reasons, [&](const Reason &one) { return !one.countsAt(now); });
    const auto known = std::ranges::find(m_reasons, reason, &Reason::text);
    if (known != m_reasons.end()) {
        known->said = now;
        return;
    }
    if (m_reasons.size() == kMost)
        m_reasons.erase(std::ranges::min_element(m_reasons, {}, &Reason::said));
    m_reasons.push_back({std::string(reason), now});
}

std::vector<std::string> PreArmReasons::at(TimePoint now) const
{
    std::vector<std::string> out;
    for (const Reason &reason : m_reasons) {
        if (reason.countsAt(now))
            out.push_back(reason.text);
    }
    return out;
}

} // namespace skyseal::vehicle
