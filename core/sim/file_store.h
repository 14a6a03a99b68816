// A small file system in memory, as the memory card of a vehicle: folders and files under normalised paths, bounded in number
// and size.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::sim {

/// Numbered as errno, which a NAK of MAVLink FTP carries.
enum class FileError : std::uint8_t {
    NotFound = 2,
    Protected = 13,
    Exists = 17,
    NotDirectory = 20,
    IsDirectory = 21,
    Invalid = 22,
    NoSpace = 28,
    NotEmpty = 39
};
template<typename T> using StoreResult = Result<T, FileError>;

inline tl::unexpected<FileError> fail(FileError error)
{
    return tl::make_unexpected(error);
}

struct FileEntry
{
    std::string name; ///< without its folder
    bool directory = false;
    std::size_t size = 0;
};

class FileStore
{
public:
    static constexpr std::size_t kMostNodes = 64;          ///< files and folders
    static constexpr std::size_t kMostBytes = 1024 * 1024; ///< of all files
    static constexpr std::size_t kLongestPath = 200;

    /// A path without "//", "." and leading or trailing slashes; "" is the root. Refused if it has "..", control characters or
    /// is too long.
    static StoreResult<std::string> normalised(std::string_view path);

    // Paths are normalised.
    StoreResult<std::vector<FileEntry>> list(const std::string &directory) const;
    /// The content of a file, valid until the next change.
    StoreResult<ByteView> read(const std::string &path) const;
    /// Makes a file, or opens the one that exists; `truncate` empties it.
    StoreResult<void> create(const std::string &path, bool truncate);
    /// Writes at an offset; a gap before it becomes zeros.
    StoreResult<void> write(const std::string &path, std::uint32_t offset, ByteView bytes);
    /// Cuts a file, or fills it up with zeros.
    StoreResult<void> truncate(const std::string &path, std::uint32_t size);
    StoreResult<void> remove(const std::string &path);
    StoreResult<void> makeDirectory(const std::string &path);
    StoreResult<void> removeDirectory(const std::string &path);
    /// Renames a file or an empty folder; the new name must not exist.
    StoreResult<void> rename(const std::string &from, const std::string &to);

    std::size_t bytes() const { return m_bytes; }
    std::size_t nodes() const { return m_nodes.size(); }

private:
    struct Node
    {
        bool directory = false;
        Bytes content;
    };
    using Nodes = std::map<std::string, Node>;
    StoreResult<Node *> file(const std::string &path);
    bool isDirectory(const std::string &path) const;
    bool hasChildren(const std::string &directory) const;
    /// Whether a new node may be made at a path.
    StoreResult<void> roomAt(const std::string &path) const;
    StoreResult<void> resize(Node &node, std::size_t size);

    Nodes m_nodes; ///< without the root
    std::size_t m_bytes = 0;
};

} // namespace skyseal::sim
