#include "core/vehicle/mission_file.h"

#include "core/base/number_text.h"
#include "core/vehicle/text_fields.h"

#include <array>
#include <cmath>
#include <limits>

namespace skyseal::vehicle {

namespace {

constexpr std::size_t kColumns = 12;
constexpr std::size_t kMostItems = 65535;
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN(); // of a parameter: the vehicle decides (PX4)

std::optional<std::array<double, kColumns>> numbersOf(const std::vector<std::string_view> &cells)
{
    std::array<double, kColumns> out{};
    for (std::size_t i = 0; i < kColumns; ++i) {
        const bool isParameter = i >= 4 && i < 8;
        const auto number = isParameter && cells[i] == "nan" ? std::optional(kNoValue) : finiteNumber(cells[i]);
        if (!number)
            return std::nullopt;
        out[i] = *number;
    }
    return out;
}

/// Sequence, command and frame are whole numbers of their width, the coordinates are on the globe.
bool isInRange(const std::array<double, kColumns> &n, std::size_t sequence)
{
    return n[0] == static_cast<double>(sequence) && n[2] >= 0 && n[2] <= 255 && n[3] >= 0 && n[3] <= 65535
        && std::abs(n[8]) <= 90 && std::abs(n[9]) <= 180;
}

} // namespace

Result<std::vector<MissionItem>, InputError> parseMission(std::string_view text, const std::string &source)
{
    const auto wrong = [&source](Reason message, std::size_t line) {
        return tl::unexpected(InputError{std::move(message), source, line});
    };
    const auto header = fieldsOf(takeLine(text), " \t");
    if (header.size() != 3 || header[0] != "QGC" || header[1] != "WPL" || header[2] != "110")
        return wrong(sentence("Reason", "not a mission file: the first line must be \"QGC WPL 110\""), 1);
    std::vector<MissionItem> items;
    for (std::size_t line = 2; !text.empty(); ++line) {
        const auto cells = fieldsOf(takeLine(text), " \t");
        if (cells.empty())
            continue;
        if (cells.size() != kColumns)
            return wrong(sentence("Reason", "an item has 12 columns, this line has %1")(cells.size()), line);
        const auto n = numbersOf(cells);
        if (!n || !isInRange(*n, items.size()))
            return wrong(sentence("Reason", "a column is not a number or is out of range, or the numbering has a gap"), line);
        if (items.size() == kMostItems)
            return wrong(sentence("Reason", "a mission has at most %1 items")(kMostItems), line);
        MissionItem item;
        item.sequence = static_cast<std::uint16_t>((*n)[0]);
        item.current = (*n)[1] != 0;
        item.frame = static_cast<std::uint8_t>((*n)[2]);
        item.command = static_cast<std::uint16_t>((*n)[3]);
        for (std::size_t p = 0; p < 4; ++p)
            item.parameters[p] = static_cast<float>((*n)[4 + p]);
        item.latitude = (*n)[8];
        item.longitude = (*n)[9];
        item.altitude = static_cast<float>((*n)[10]);
        item.autoContinue = (*n)[11] != 0;
        items.push_back(item);
    }
    if (items.empty())
        return wrong(sentence("Reason", "the mission has no items"), 0);
    return items;
}

std::string missionText(const std::vector<MissionItem> &items)
{
    std::string out = "QGC WPL 110\n";
    for (const MissionItem &item : items) {
        for (const unsigned number :
             {unsigned(item.sequence), unsigned(item.current), unsigned(item.frame), unsigned(item.command)})
            out += std::to_string(number) + '\t';
        for (const float parameter : item.parameters)
            out += numberText(parameter) + '\t';
        out += fixedText(item.latitude, 8) + '\t' + fixedText(item.longitude, 8) + '\t' + numberText(item.altitude) + '\t'
            + (item.autoContinue ? "1\n" : "0\n");
    }
    return out;
}

} // namespace skyseal::vehicle
