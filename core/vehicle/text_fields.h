// Reading of the text files that ground stations share: lines and columns.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

/// Without the byte order mark that editors put before UTF-8.
inline std::string_view withoutMark(std::string_view text)
{
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

/// The next line, without its end: \n, \r\n or \r. `rest` becomes what follows it.
inline std::string_view takeLine(std::string_view &rest)
{
    const std::size_t end = rest.find_first_of("\r\n");
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(line.size());
    rest.remove_prefix(rest.starts_with("\r\n") ? 2 : rest.empty() ? 0 : 1);
    return line;
}

/// Without the blanks around it.
inline std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlank = " \t";
    text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
    return text.substr(0, text.find_last_not_of(kBlank) + 1);
}

/// The parts of a line between any of these separators, of which there may be as many as the line has characters: no more than
/// the first kMostFields. Empty parts are left out.
inline constexpr std::size_t kMostFields = 100;
inline std::vector<std::string_view> fieldsOf(std::string_view line, std::string_view separators)
{
    std::vector<std::string_view> out;
    for (;;) {
        const std::size_t begin = line.find_first_not_of(separators);
        if (begin == std::string_view::npos || out.size() == kMostFields)
            return out;
        line.remove_prefix(begin);
        const std::size_t end = line.find_first_of(separators);
        out.push_back(line.substr(0, end));
        line.remove_prefix(out.back().size());
    }
}

} // namespace skyseal::vehicle
