#include "core/keys/peers_file.h"

#include "core/keys/file_io.h"
#include "core/keys/peer_line.h"

#include <algorithm>

namespace skyseal::keys {

Result<PeersFile, InputError> PeersFile::parse(std::string_view text, const std::string &source)
{
    PeersFile file;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        const std::string_view raw = text.substr(0, end);
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
        Line line{std::string(raw), isPeerLine(raw), {}};
        if (line.isPeer) {
            auto entry = parsePeerLine(raw);
            const auto fits = entry ? file.check(*entry, nullptr) : Result<void, InputError>();
            if (!entry || !fits) {
                InputError error = entry ? fits.error() : entry.error();
                error.source = source;
                error.line = number;
                return tl::unexpected(error);
            }
            line.entry = std::move(*entry);
        }
        file.m_lines.push_back(std::move(line));
    }
    return file;
}

Result<PeersFile, InputError> PeersFile::load(const std::string &path)
{
    if (!fileExists(path))
        return tl::unexpected(InputError{sentence("Reason", "does not exist; keys pair and keys peers add create it"), path});
    const auto content = readFile(path, FileAccess::Trusted);
    if (!content)
        return tl::unexpected(content.error());
    return parse(asText(*content), path);
}

Result<PeersFile, InputError> PeersFile::loadOrEmpty(const std::string &path)
{
    return fileExists(path) ? load(path) : PeersFile();
}

Result<void, InputError> PeersFile::save(const std::string &path) const
{
    return replaceFile(path, asBytes(text()));
}

std::string PeersFile::text() const
{
    std::string out;
    for (const Line &line : m_lines)
        out.append(line.raw).append("\n");
    return out;
}

std::vector<PeerEntry> PeersFile::entries() const
{
    std::vector<PeerEntry> out;
    for (const Line &line : m_lines) {
        if (line.isPeer)
            out.push_back(line.entry);
    }
    return out;
}

std::vector<channel::Peer> PeersFile::peers() const
{
    std::vector<channel::Peer> out;
    for (const Line &line : m_lines) {
        if (line.isPeer)
            out.push_back(line.entry.peer);
    }
    return out;
}

PeersFile::Line *PeersFile::lineOf(std::string_view name)
{
    const auto found = std::find_if(m_lines.begin(), m_lines.end(),
                                    [name](const Line &line) { return line.isPeer && line.entry.peer.name == name; });
    return found == m_lines.end() ? nullptr : &*found;
}

const PeerEntry *PeersFile::find(std::string_view name) const
{
    const auto found = std::find_if(m_lines.begin(), m_lines.end(),
                                    [name](const Line &line) { return line.isPeer && line.entry.peer.name == name; });
    return found == m_lines.end() ? nullptr : &found->entry;
}

const PeerEntry *PeersFile::findKey(const channel::PublicKey &key) const
{
    const auto found = std::find_if(m_lines.begin(), m_lines.end(),
                                    [&](const Line &line) { return line.isPeer && line.entry.peer.key == key; });
    return found == m_lines.end() ? nullptr : &found->entry;
}

Acquaintance PeersFile::acquaintance(std::string_view name, const channel::PublicKey &key) const
{
    const PeerEntry *byName = find(name);
    if (byName && byName->peer.key == key)
        return Acquaintance::Known;
    if (byName)
        return Acquaintance::KeyChanged;
    return findKey(key) ? Acquaintance::OtherName : Acquaintance::Stranger;
}

/// Names and keys are unique: with two lines for one key its role would be ambiguous.
Result<void, InputError> PeersFile::check(const PeerEntry &entry, const Line *except) const
{
    if (auto fits = checkPeerEntry(entry); !fits)
        return fits;
    std::size_t others = 0;
    for (const Line &line : m_lines) {
        if (!line.isPeer || &line == except)
            continue;
        if (++others == kMostPeers)
            return tl::unexpected(InputError{sentence("Reason", "a list has at most %1 peers")(kMostPeers), {}});
        if (line.entry.peer.name == entry.peer.name)
            return tl::unexpected(InputError{sentence("Reason", "there is a peer named \"%1\" already")(entry.peer.name), {}});
        if (line.entry.peer.key == entry.peer.key)
            return tl::unexpected(
                InputError{sentence("Reason", "the peer \"%1\" has the same key already")(line.entry.peer.name), {}});
    }
    return {};
}

Result<void, InputError> PeersFile::add(PeerEntry entry)
{
    if (auto fits = check(entry, nullptr); !fits)
        return fits;
    std::string raw = formatPeerLine(entry);
    m_lines.push_back({std::move(raw), true, std::move(entry)});
    return {};
}

Result<void, InputError> PeersFile::replace(PeerEntry entry)
{
    const std::string name = entry.peer.name;
    return exchange(name, std::move(entry));
}

Result<void, InputError> PeersFile::rename(std::string_view name, const std::string &newName)
{
    const PeerEntry *known = find(name);
    PeerEntry entry = known ? *known : PeerEntry();
    entry.peer.name = newName;
    return exchange(name, std::move(entry));
}

Result<void, InputError> PeersFile::exchange(std::string_view name, PeerEntry entry)
{
    Line *line = lineOf(name);
    if (!line)
        return tl::unexpected(InputError{sentence("Reason", "there is no peer named \"%1\"")(std::string(name)), {}});
    if (auto fits = check(entry, line); !fits)
        return fits;
    line->raw = formatPeerLine(entry);
    line->entry = std::move(entry);
    return {};
}

bool PeersFile::remove(std::string_view name)
{
    return std::erase_if(m_lines, [name](const Line &line) { return line.isPeer && line.entry.peer.name == name; }) > 0;
}

Result<void, InputError> editPeers(const std::string &path, const std::function<Result<void, InputError>(PeersFile &)> &change)
{
    const auto lock = FileLock::take(path);
    if (!lock)
        return tl::unexpected(lock.error());
    auto file = PeersFile::loadOrEmpty(path);
    if (!file)
        return tl::unexpected(file.error());
    if (const auto changed = change(*file); !changed) {
        InputError error = changed.error();
        error.source = path;
        return tl::unexpected(error);
    }
    return file->save(path);
}

Result<bool, InputError> createMissingPeers(const std::string &path)
{
    if (fileExists(path))
        return false;
    const auto created = createFile(path, {});
    return created ? Result<bool, InputError>(true) : tl::unexpected(created.error());
}

std::string presharedKeyPath(const std::string &peersFile, const PeerEntry &entry)
{
    const std::string &file = entry.presharedKeyFile;
    const std::size_t slash = peersFile.rfind('/');
    if (file.empty() || file.starts_with('/') || slash == std::string::npos)
        return file;
    return peersFile.substr(0, slash + 1) + file;
}

Result<std::vector<channel::Peer>, InputError> loadPeers(const std::string &path)
{
    return PeersFile::load(path).map([](const PeersFile &file) { return file.peers(); });
}

} // namespace skyseal::keys
