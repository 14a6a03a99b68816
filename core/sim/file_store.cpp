#include "core/sim/file_store.h"

#include <algorithm>

namespace skyseal::sim {

namespace {

std::string folderOf(const std::string &path)
{
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

/// Name of `path` if it lies directly in `directory`, else "".
std::string nameWithin(const std::string &directory, const std::string &path)
{
    return folderOf(path) == directory ? path.substr(directory.empty() ? 0 : directory.size() + 1) : std::string();
}

} // namespace

StoreResult<std::string> FileStore::normalised(std::string_view path)
{
    if (path.size() > kLongestPath)
        return fail(FileError::Invalid);
    std::string out;
    while (!path.empty()) {
        const std::string_view part = path.substr(0, path.find('/'));
        path.remove_prefix(std::min(part.size() + 1, path.size()));
        if (part.empty() || part == ".")
            continue;
        if (part == ".." || std::any_of(part.begin(), part.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
            return fail(FileError::Invalid);
        if (!out.empty())
            out += '/';
        out += part;
    }
    return out;
}

bool FileStore::isDirectory(const std::string &path) const
{
    const auto at = m_nodes.find(path);
    return path.empty() || (at != m_nodes.end() && at->second.directory);
}

bool FileStore::hasChildren(const std::string &directory) const
{
    return std::any_of(m_nodes.begin(), m_nodes.end(), [&](const auto &node) { return folderOf(node.first) == directory; });
}

StoreResult<FileStore::Node *> FileStore::file(const std::string &path)
{
    if (isDirectory(path))
        return fail(FileError::IsDirectory);
    const auto at = m_nodes.find(path);
    if (at == m_nodes.end())
        return fail(FileError::NotFound);
    return &at->second;
}

StoreResult<void> FileStore::roomAt(const std::string &path) const
{
    if (path.empty() || m_nodes.contains(path))
        return fail(FileError::Exists);
    const std::string folder = folderOf(path);
    if (!isDirectory(folder))
        return fail(m_nodes.contains(folder) ? FileError::NotDirectory : FileError::NotFound);
    if (m_nodes.size() >= kMostNodes)
        return fail(FileError::NoSpace);
    return {};
}

StoreResult<void> FileStore::resize(Node &node, std::size_t size)
{
    if (size > kMostBytes || m_bytes - node.content.size() > kMostBytes - size)
        return fail(FileError::NoSpace);
    m_bytes = m_bytes - node.content.size() + size;
    node.content.resize(size);
    return {};
}

StoreResult<std::vector<FileEntry>> FileStore::list(const std::string &directory) const
{
    if (!isDirectory(directory))
        return fail(m_nodes.contains(directory) ? FileError::NotDirectory : FileError::NotFound);
    std::vector<FileEntry> entries;
    for (const auto &[path, node] : m_nodes) {
        if (std::string name = nameWithin(directory, path); !name.empty())
            entries.push_back({std::move(name), node.directory, node.content.size()});
    }
    return entries;
}

StoreResult<ByteView> FileStore::read(const std::string &path) const
{
    if (isDirectory(path))
        return fail(FileError::IsDirectory);
    const auto at = m_nodes.find(path);
    if (at == m_nodes.end())
        return fail(FileError::NotFound);
    return ByteView(at->second.content);
}

StoreResult<void> FileStore::create(const std::string &path, bool truncate)
{
    if (const auto existing = file(path)) {
        if (truncate)
            return resize(**existing, 0);
        return {};
    } else if (existing.error() != FileError::NotFound) {
        return fail(existing.error());
    }
    if (const auto room = roomAt(path); !room)
        return room;
    m_nodes[path] = {};
    return {};
}

StoreResult<void> FileStore::write(const std::string &path, std::uint32_t offset, ByteView bytes)
{
    const auto node = file(path);
    if (!node)
        return fail(node.error());
    Bytes &content = (*node)->content;
    if (offset > kMostBytes)
        return fail(FileError::NoSpace);
    if (const auto resized = resize(**node, std::max(content.size(), offset + bytes.size())); !resized)
        return resized;
    std::copy(bytes.begin(), bytes.end(), content.begin() + offset);
    return {};
}

StoreResult<void> FileStore::truncate(const std::string &path, std::uint32_t size)
{
    const auto node = file(path);
    if (!node)
        return fail(node.error());
    return resize(**node, size);
}

StoreResult<void> FileStore::remove(const std::string &path)
{
    const auto node = file(path);
    if (!node)
        return fail(node.error());
    m_bytes -= (*node)->content.size();
    m_nodes.erase(path);
    return {};
}

StoreResult<void> FileStore::makeDirectory(const std::string &path)
{
    if (const auto room = roomAt(path); !room)
        return room;
    m_nodes[path].directory = true;
    return {};
}

StoreResult<void> FileStore::removeDirectory(const std::string &path)
{
    const auto at = m_nodes.find(path);
    if (at == m_nodes.end())
        return fail(path.empty() ? FileError::Protected : FileError::NotFound);
    if (!at->second.directory)
        return fail(FileError::NotDirectory);
    if (hasChildren(path))
        return fail(FileError::NotEmpty);
    m_nodes.erase(at);
    return {};
}

StoreResult<void> FileStore::rename(const std::string &from, const std::string &to)
{
    const auto at = m_nodes.find(from);
    if (at == m_nodes.end())
        return fail(FileError::NotFound);
    if (at->second.directory && hasChildren(from))
        return fail(FileError::NotEmpty);
    if (to == from)
        return {};
    auto moved = m_nodes.extract(at); // makes room for the new name, and a folder cannot move into itself
    const auto room = roomAt(to);
    moved.key() = room ? to : from;
    m_nodes.insert(std::move(moved));
    return room;
}

} // namespace skyseal::sim
