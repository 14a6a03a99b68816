#include "core/keys/counter_file.h"

#include "core/base/hex.h"
#include "core/keys/file_io.h"

#include <algorithm>
#include <charconv>

namespace skyseal::keys {

static constexpr std::string_view kHeader = "skyseal-counters-v1";
static constexpr std::string_view kNext = "next ";
static constexpr std::string_view kSeen = "seen ";

static std::optional<std::uint64_t> numberOf(std::string_view text)
{
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

static bool readSeen(std::string_view text, Counters &counters)
{
    static constexpr std::size_t kKeyDigits = 64;
    if (text.size() < kKeyDigits + 2 || text[kKeyDigits] != ' ')
        return false;
    const std::optional<Bytes> bytes = fromHex(text.substr(0, kKeyDigits));
    const std::optional<std::uint64_t> number = numberOf(text.substr(kKeyDigits + 1));
    if (!bytes || !number)
        return false;
    channel::PublicKey key{};
    std::copy(bytes->begin(), bytes->end(), key.begin());
    return counters.seen.emplace(key, *number).second;
}

Result<Counters, InputError> Counters::parse(std::string_view text, const std::string &source)
{
    const auto damaged = [&source](std::size_t line) {
        return tl::unexpected(fileError(source, "is not a counter file of Skyseal, or is damaged", line));
    };
    Counters counters;
    bool hasNext = false;
    // Every line ends with a newline, so that a truncated number is detected.
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos)
            return damaged(number);
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end + 1);
        if (number == 1) {
            if (line != kHeader)
                return damaged(number);
        } else if (line.starts_with(kNext) && !hasNext) {
            const auto value = numberOf(line.substr(kNext.size()));
            if (!value)
                return damaged(number);
            counters.next = *value;
            hasNext = true;
        } else if (!line.starts_with(kSeen) || !readSeen(line.substr(kSeen.size()), counters)) {
            return damaged(number);
        }
    }
    return hasNext ? Result<Counters, InputError>(std::move(counters)) : damaged(0);
}

std::string Counters::text() const
{
    std::string out(kHeader);
    out.append("\n").append(kNext).append(std::to_string(next)).append("\n");
    for (const auto &[key, number] : seen)
        out.append(kSeen).append(toHex(key)).append(" ").append(std::to_string(number)).append("\n");
    return out;
}

Result<std::unique_ptr<FileCounterStore>, InputError> FileCounterStore::open(const std::string &path, std::uint64_t first)
{
    std::unique_ptr<FileCounterStore> store(new FileCounterStore(path));
    store->m_counters.next = first;
    const auto lock = FileLock::take(path);
    if (!lock)
        return tl::unexpected(lock.error());
    if (fileExists(path) ? !store->refresh() : !store->write())
        return tl::unexpected(store->m_error);
    return store;
}

/// Merges the changes of other programs; counters never decrease.
bool FileCounterStore::refresh()
{
    const auto content = readFile(m_path, FileAccess::Trusted);
    auto read = content ? Counters::parse(asText(*content), m_path)
                        : Result<Counters, InputError>(tl::unexpected(content.error()));
    if (!read) {
        m_error = read.error();
        return false;
    }
    m_counters.next = std::max(m_counters.next, read->next);
    for (const auto &[key, number] : read->seen) {
        std::uint64_t &known = m_counters.seen[key];
        known = std::max(known, number);
    }
    return true;
}

bool FileCounterStore::write()
{
    const auto written = replaceFile(m_path, asBytes(m_counters.text()));
    m_error = written ? InputError() : written.error();
    return written.has_value();
}

std::uint64_t FileCounterStore::next()
{
    const auto lock = FileLock::take(m_path);
    if (lock)
        refresh();
    else
        m_error = lock.error();
    const std::uint64_t number = m_counters.next++;
    // A number that could not be stored is used nevertheless: if it repeats, the peer just rejects the message.
    if (lock)
        write();
    return number;
}

bool FileCounterStore::skipTo(std::uint64_t counter)
{
    const auto lock = FileLock::take(m_path);
    if (!lock) {
        m_error = lock.error();
        return false;
    }
    if (!refresh())
        return false;
    m_counters.next = std::max(m_counters.next, counter + 1);
    return write();
}

std::uint64_t FileCounterStore::lastSeen(const channel::PublicKey &peer)
{
    const auto found = m_counters.seen.find(peer);
    return found == m_counters.seen.end() ? 0 : found->second;
}

bool FileCounterStore::remember(const channel::PublicKey &peer, std::uint64_t counter)
{
    const auto lock = FileLock::take(m_path);
    if (!lock) {
        m_error = lock.error();
        return false;
    }
    if (!refresh())
        return false;
    std::uint64_t &known = m_counters.seen[peer];
    known = std::max(known, counter);
    return write();
}

} // namespace skyseal::keys
