// Missions, fences and rally points in the plain text format that ground stations share ("QGC WPL 110").
// https://mavlink.io/en/file_formats/#mission_plain_text_file
#pragma once

#include "core/base/result.h"
#include "core/vehicle/mission.h"

#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

struct MissionFile
{
    std::vector<MissionItem> items; ///< numbered from 0
    /// The file says that it has no home position as its first item: its version is 120 (QGroundControl's for PX4), or its
    /// numbers begin at 1. Otherwise only the first item itself tells (isLikeHome()).
    bool withoutHome = false;
};

/// Parses the text of a file; `source` is its name in errors, which also say the line and the character in it. At most 65,535
/// items, numbered one after the other from 0 or 1, with frames in the form of plainFrame(). A # begins a comment; NaN, in any
/// case, is a parameter that is not used.
Result<MissionFile, InputError> parseMission(std::string_view text, const std::string &source);
std::string missionText(const std::vector<MissionItem> &items);

} // namespace skyseal::vehicle
