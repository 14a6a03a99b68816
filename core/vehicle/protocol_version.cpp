#include "core/vehicle/protocol_version.h"

#include "core/vehicle/reasons.h"

#include <type_traits>

namespace skyseal::vehicle {

Reason unfitForVersion1(const Request &request)
{
    // Without its extension, a message about a fence or rally points is one about the mission.
    const auto isUnfit = []<typename T>(const T &of) {
        if constexpr (requires { requires std::is_same_v<std::remove_cvref_t<decltype(of.type)>, MissionType>; })
            return of.type != MissionType::Mission;
        return false;
    };
    return std::visit(isUnfit, request) ? Reason(reasons::kPlanNeedsVersion2) : Reason();
}

} // namespace skyseal::vehicle
