#include "core/vehicle/ftp_listing.h"

#include "core/base/printable.h"

#include <charconv>
#include <optional>
#include <string_view>

namespace skyseal::vehicle {

namespace {

/// "Fname\tsize", "Dname"; nullopt for others, such as "S" for an entry that is skipped.
std::optional<RemoteFile> entryIn(std::string_view text)
{
    if (text.size() < 2 || (text[0] != 'F' && text[0] != 'D'))
        return std::nullopt;
    RemoteFile out;
    out.isFolder = text[0] == 'D';
    const std::size_t tab = text.find('\t');
    out.name = printable(text.substr(1, tab == std::string_view::npos ? tab : tab - 1));
    if (tab != std::string_view::npos && !out.isFolder)
        std::from_chars(text.data() + tab + 1, text.data() + text.size(), out.size);
    return out;
}

} // namespace

FtpListing parseListing(ByteView data)
{
    FtpListing out;
    std::string_view rest = asText(data);
    while (!rest.empty()) {
        const std::size_t end = rest.find('\0');
        const std::string_view text = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (text.empty())
            continue;
        ++out.count;
        if (auto entry = entryIn(text))
            out.entries.push_back(std::move(*entry));
    }
    return out;
}

} // namespace skyseal::vehicle
