#include "core/vehicle/mission_file.h"

#include "core/base/number_text.h"
#include "core/base/printable.h"
#include "core/vehicle/mission_edit.h"
#include "core/vehicle/mission_place.h"
#include "core/vehicle/text_fields.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace skyseal::vehicle {

namespace {

constexpr std::size_t kColumns = 12;
constexpr std::size_t kMostItems = 65535;
constexpr std::size_t kParameters = 4, kLatitude = 8, kLongitude = 9, kAltitude = 10; ///< columns, from 0

/// Why a line is refused, and the place in it.
struct LineProblem
{
    Reason message;
    std::size_t column = 0; ///< 1-based character, 0: the whole line
};

tl::unexpected<LineProblem> problem(Reason message, std::size_t column = 0)
{
    return tl::unexpected(LineProblem{std::move(message), column});
}

bool isNan(std::string_view text)
{
    if (text.starts_with('-'))
        text.remove_prefix(1);
    return text.size() == 3 && (text[0] | 32) == 'n' && (text[1] | 32) == 'a' && (text[2] | 32) == 'n';
}

/// The columns of one item; its errors quote the column and name its place.
class ItemLine
{
public:
    /// `content` is the part of `line` before a comment.
    ItemLine(std::string_view line, std::string_view content) : m_line(line), m_cells(fieldsOf(content, " \t")) {}

    std::size_t size() const { return m_cells.size(); }

    template<typename... Values> tl::unexpected<LineProblem> wrong(std::size_t column, Sentence why, Values... values) const
    {
        return problem(why(printable(std::string(m_cells[column].substr(0, 40))), values...),
                       static_cast<std::size_t>(m_cells[column].data() - m_line.data()) + 1);
    }

    /// A number; a NaN where a parameter may be unused.
    Result<double, LineProblem> number(std::size_t column) const
    {
        const std::string_view cell = m_cells[column];
        if (column >= kParameters && column <= kAltitude && isNan(cell))
            return std::numeric_limits<double>::quiet_NaN();
        if (const auto value = finiteNumber(cell); value && std::abs(*value) <= double(std::numeric_limits<float>::max()))
            return *value;
        std::string withPoint(cell);
        const std::size_t comma = withPoint.find(',');
        if (comma != std::string::npos && finiteNumber(withPoint.replace(comma, 1, 1, '.')))
            return wrong(column, sentence("Reason", "\"%1\" has a decimal comma; numbers in files have a point"));
        return wrong(column, sentence("Reason", "\"%1\" is not a number"));
    }

    Result<std::uint16_t, LineProblem> whole(std::size_t column, unsigned most) const
    {
        const auto value = number(column);
        if (!value)
            return tl::unexpected(value.error());
        if (!(*value >= 0 && *value <= most && *value == std::floor(*value)))
            return wrong(column, sentence("Reason", "\"%1\" is not a whole number from 0 to %2"), most);
        return static_cast<std::uint16_t>(*value);
    }

private:
    std::string_view m_line;
    std::vector<std::string_view> m_cells;
};

Result<MissionItem, LineProblem> itemIn(const ItemLine &line)
{
    if (line.size() == kMostFields)
        return problem(sentence("Reason", "an item has 12 columns, this line has %1 or more")(line.size()));
    if (line.size() != kColumns)
        return problem(sentence("Reason", "an item has 12 columns, this line has %1")(line.size()));
    constexpr unsigned kMost[] = {65535, 255, 255, 65535};
    std::array<std::uint16_t, std::size(kMost)> wholes{};
    for (std::size_t column = 0; column < wholes.size(); ++column) {
        const auto value = line.whole(column, kMost[column]);
        if (!value)
            return tl::unexpected(value.error());
        wholes[column] = *value;
    }
    std::array<double, kColumns> numbers{};
    for (std::size_t column = wholes.size(); column < kColumns; ++column) {
        const auto value = line.number(column);
        if (!value)
            return tl::unexpected(value.error());
        numbers[column] = *value;
    }
    MissionItem item{.sequence = wholes[0],
                     .command = wholes[3],
                     .frame = plainFrame(static_cast<std::uint8_t>(wholes[2])),
                     .current = wholes[1] != 0,
                     .autoContinue = numbers[kColumns - 1] != 0,
                     .latitude = numbers[kLatitude],
                     .longitude = numbers[kLongitude],
                     .altitude = static_cast<float>(numbers[kAltitude])};
    for (std::size_t p = 0; p < std::size(item.parameters); ++p)
        item.parameters[p] = static_cast<float>(numbers[kParameters + p]);
    if (isGlobal(item) && std::abs(item.latitude) > 90)
        return line.wrong(kLatitude, sentence("Reason", "\"%1\" is not a latitude from -90 to 90"));
    if (isGlobal(item) && std::abs(item.longitude) > 180)
        return line.wrong(kLongitude, sentence("Reason", "\"%1\" is not a longitude from -180 to 180"));
    return item;
}

/// The version in the first line; nullopt if this is no mission file, or one of another version.
Result<int, LineProblem> versionIn(std::string_view line)
{
    const auto words = fieldsOf(line, " \t");
    if (words.size() == 3 && words[0] == "QGC" && words[1] == "WPL") {
        if (words[2] == "110" || words[2] == "120")
            return words[2] == "110" ? 110 : 120;
        return problem(sentence("Reason", "version %1 of mission files is not known, only 110 and 120")(
            printable(std::string(words[2].substr(0, 40)))));
    }
    if (!words.empty() && words[0].starts_with('{'))
        return problem(sentence("Reason", "this is a plan in JSON; mission files begin with \"QGC WPL 110\""));
    return problem(sentence("Reason", "not a mission file: the first line must be \"QGC WPL 110\""));
}

} // namespace

Result<MissionFile, InputError> parseMission(std::string_view text, const std::string &source)
{
    std::size_t number = 0;
    const auto wrong = [&source, &number](LineProblem found) {
        return tl::unexpected(InputError{std::move(found.message), source, number, found.column});
    };
    text = withoutMark(text);
    MissionFile out;
    std::optional<int> version;
    std::size_t first = 0; // number of the first item
    while (!text.empty()) {
        const std::string_view line = takeLine(text);
        ++number;
        const std::string_view content = trimmed(line.substr(0, line.find('#')));
        if (content.empty())
            continue;
        if (!version) {
            const auto read = versionIn(content);
            if (!read)
                return wrong(read.error());
            version = *read;
            continue;
        }
        const ItemLine cells(line, content);
        auto item = itemIn(cells);
        if (!item)
            return wrong(item.error());
        if (out.items.empty() && item->sequence == 1)
            first = 1;
        if (item->sequence != first + out.items.size())
            return wrong(
                cells.wrong(0, sentence("Reason", "item %1 stands where item %2 is expected"), first + out.items.size())
                    .value());
        if (out.items.size() == kMostItems)
            return wrong({sentence("Reason", "a mission has at most %1 items")(kMostItems)});
        out.items.push_back(*item);
    }
    if (!version) {
        number = 1;
        return wrong(versionIn({}).error());
    }
    if (out.items.empty()) {
        number = 0;
        return wrong({sentence("Reason", "the file has no items after its first line")});
    }
    out.withoutHome = *version == 120 || first == 1;
    if (first == 1)
        renumber(out.items, 1, -1);
    return out;
}

std::string missionText(const std::vector<MissionItem> &items)
{
    std::string out = "QGC WPL 110\n";
    for (const MissionItem &item : items) {
        for (const unsigned number :
             {unsigned(item.sequence), unsigned(item.current), unsigned(plainFrame(item.frame)), unsigned(item.command)})
            out += std::to_string(number) + '\t';
        for (const float parameter : item.parameters)
            out += numberText(parameter) + '\t';
        out += fixedText(item.latitude, 8) + '\t' + fixedText(item.longitude, 8) + '\t' + numberText(item.altitude) + '\t'
            + (item.autoContinue ? "1\n" : "0\n");
    }
    return out;
}

} // namespace skyseal::vehicle
