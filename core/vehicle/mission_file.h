// Missions, fences and rally points in the plain text format that ground stations share ("QGC WPL 110").
// https://mavlink.io/en/file_formats/
#pragma once

#include "core/base/result.h"
#include "core/vehicle/mission.h"

#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

/// Parses the text of a file; `source` is its name in errors. At most 65,535 items.
Result<std::vector<MissionItem>, InputError> parseMission(std::string_view text, const std::string &source);
std::string missionText(const std::vector<MissionItem> &items);

} // namespace skyseal::vehicle
