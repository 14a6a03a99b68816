#include "core/log/link_events.h"

#include "core/base/printable.h"
#include "core/base/utf8.h"
#include "core/log/open_log.h"
#include "core/log/tlog_entry.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>

namespace skyseal::tlog {

namespace {

constexpr std::array<std::string_view, 3> kKinds{"sealed", "switched", "plain"}; // in the order of LinkEvent::Kind

bool isSuiteName(std::string_view text)
{
    const auto isPart = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
    return !text.empty() && text.size() <= LinkEvent::kLongestSuite && std::ranges::all_of(text, isPart);
}

/// Takes the text up to the next space, and that space, from the front of `line`.
std::string_view takeWord(std::string_view &line)
{
    const std::string_view word = line.substr(0, line.find(' '));
    line.remove_prefix(std::min(line.size(), word.size() + 1));
    return word;
}

std::optional<WallTime> timeOf(std::string_view word)
{
    std::int64_t microseconds = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), microseconds);
    if (error != std::errc() || end != word.data() + word.size())
        return std::nullopt;
    const WallTime time{std::chrono::microseconds(microseconds)};
    return isPlausible(time) ? std::optional(time) : std::nullopt;
}

/// Cut between two characters.
std::string_view shortened(std::string_view text, std::size_t most)
{
    std::size_t length = 0;
    while (length < text.size()) {
        const std::size_t next = length + firstCharacter(text.substr(length)).length;
        if (next > most)
            break;
        length = next;
    }
    return text.substr(0, length);
}

} // namespace

std::string lineOf(const LinkEvent &event)
{
    const std::string peer = printable(event.peer);
    std::string out = std::to_string(std::max(event.time, WallTime()).time_since_epoch().count());
    out.append(" ").append(kKinds[static_cast<std::size_t>(event.kind)]).append(" ").append(event.suite);
    if (!peer.empty())
        out.append(" ").append(shortened(peer, LinkEvent::kLongestPeer));
    return out + '\n';
}

std::optional<LinkEvent> linkEventOf(std::string_view line)
{
    const auto time = timeOf(takeWord(line));
    const auto kind = std::ranges::find(kKinds, takeWord(line));
    const std::string_view suite = takeWord(line), peer = line;
    if (!time || kind == kKinds.end() || !isSuiteName(suite) || peer.size() > LinkEvent::kLongestPeer || !isPrintable(peer))
        return std::nullopt;
    return LinkEvent{static_cast<LinkEvent::Kind>(kind - kKinds.begin()), *time, std::string(suite), std::string(peer)};
}

LinkEvents readLinkEvents(std::istream &input)
{
    LinkEvents out;
    std::string text(LinkEvents::kMostBytes, '\0');
    input.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(input.gcount()));
    std::string_view left = text;
    while (!left.empty()) {
        const std::size_t end = left.find('\n');
        const std::string_view line = left.substr(0, end);
        if (out.events.size() == LinkEvents::kMost) {
            ++out.unreadable;
            return out;
        }
        // A line without its end was cut, although it may look like a shorter one.
        if (auto event = end == std::string_view::npos ? std::nullopt : linkEventOf(line))
            out.events.push_back(std::move(*event));
        else if (!line.starts_with('#'))
            ++out.unreadable;
        left.remove_prefix(std::min(left.size(), line.size() + 1));
    }
    if (text.size() == LinkEvents::kMostBytes && input.peek() != std::istream::traits_type::eof())
        ++out.unreadable;
    return out;
}

std::string linkEventsFile(const std::string &recording)
{
    return recording + ".events";
}

LinkEvents linkEventsOf(const std::string &recording)
{
    const std::string path = linkEventsFile(recording);
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        return {};
    auto file = openLog(path);
    return file ? readLinkEvents(*file) : LinkEvents{{}, 1};
}

} // namespace skyseal::tlog
