// A checklist before a flight, as a text file. One item a line; empty lines and those that begin with '#' are skipped. An item
// that the vehicle can answer ends with a condition in brackets, in the grammar of flight scripts (flight_script.h):
//
//   # Quadrotor of the club
//   Propellers tight
//   Battery full [battery_percent>=90]
//   Position known [gps_fix>=3]
#pragma once

#include "core/base/result.h"
#include "core/vehicle/flight_script.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

struct ChecklistItem
{
    std::string text;
    std::optional<WaitUntil> condition; ///< nullopt: ticked by hand
    std::string conditionText;          ///< as written
};

struct Checklist
{
    std::vector<ChecklistItem> items;
    /// One for each line whose condition cannot be read, with its number. Its item is there all the same, to be ticked by hand.
    std::vector<InputError> problems;
};

/// Longest file, and longest item, in bytes; most items.
inline constexpr std::size_t kMaxChecklistSize = 65536, kMaxChecklistItem = 200, kMaxChecklistItems = 200;

/// Reads the text of a file; `source` names it in errors. Fails if the text is too long, is not text or has no item.
Result<Checklist, InputError> parseChecklist(std::string_view text, const std::string &source);

} // namespace skyseal::vehicle
