// Mission files in the plain text format that ground stations share ("QGC WPL 110").
#pragma once

#include "core/base/result.h"
#include "core/vehicle/mission.h"

#include <string>
#include <string_view>
#include <vector>

namespace skyseal::ui {

/// Parses the text of a file; `source` is its name in errors.
Result<std::vector<vehicle::MissionItem>, InputError> parseMission(std::string_view text, const std::string &source);
std::string missionText(const std::vector<vehicle::MissionItem> &items);

} // namespace skyseal::ui
