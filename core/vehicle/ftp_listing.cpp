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

std::string ftpErrorText(const mavlink::FtpMessage &refusal)
{
    const std::uint8_t error = refusal.error().value_or(mavlink::MAV_FTP_ERR_FAIL);
    switch (error) {
    case mavlink::MAV_FTP_ERR_FAIL: return "the vehicle reports a failure";
    case mavlink::MAV_FTP_ERR_FAILERRNO:
        if (refusal.size > 1 && refusal.data[1] == 2)
            return "no such file or folder";
        return "the vehicle reports error " + std::to_string(refusal.size > 1 ? refusal.data[1] : 0);
    case mavlink::MAV_FTP_ERR_INVALIDDATASIZE: return "the vehicle refuses the size";
    case mavlink::MAV_FTP_ERR_INVALIDSESSION: return "the vehicle has closed the file";
    case mavlink::MAV_FTP_ERR_NOSESSIONSAVAILABLE: return "too many files are open on the vehicle";
    case mavlink::MAV_FTP_ERR_EOF: return "end of file";
    case mavlink::MAV_FTP_ERR_UNKNOWNCOMMAND: return "not supported by the vehicle";
    case mavlink::MAV_FTP_ERR_FILEEXISTS: return "the file exists";
    case mavlink::MAV_FTP_ERR_FILEPROTECTED: return "the file is protected";
    case mavlink::MAV_FTP_ERR_FILENOTFOUND: return "no such file or folder";
    }
    return "the vehicle reports error code " + std::to_string(error);
}

} // namespace skyseal::vehicle
