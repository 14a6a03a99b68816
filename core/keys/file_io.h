// Reads and replaces small files safely: owner and permissions are checked on the open descriptor, and a reader never sees a
// partial new version, even if a process is killed while it writes.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <chrono>
#include <string>
#include <utility>

namespace skyseal::keys {

/// The permissions a file must have to be read. It must belong to the user of the process or to the superuser.
enum class FileAccess {
    Private, ///< not readable by other users, not a symbolic link: private keys
    Trusted, ///< not writable by other users: lists of trusted peers
};

/// Larger files are rejected.
inline constexpr std::size_t kMaxFileSize = 1 << 20;

inline InputError fileError(const std::string &path, Reason message, std::size_t line = 0)
{
    return {std::move(message), path, line, 0};
}

/// The whole file. The caller wipes a secret one.
Result<Bytes, InputError> readFile(const std::string &path, FileAccess access);
bool fileExists(const std::string &path);

/// Creates a file, readable by the owner only, and syncs it to the disk. Fails if it exists.
Result<void, InputError> createFile(const std::string &path, ByteView content);

/// Replaces a file atomically, or creates it: written to a temporary file, synced, renamed. Keeps the permissions of the old
/// file; a new one is accessible by the owner only.
Result<void, InputError> replaceFile(const std::string &path, ByteView content);
/// As replaceFile() for a secret: afterwards the file is accessible by the owner only, in any case.
Result<void, InputError> replaceSecretFile(const std::string &path, ByteView content);

/// An exclusive lock across processes for changes of a file, held while the object lives. The lock is the file `path`.lock.
class FileLock
{
public:
    /// How long take() waits for another program.
    static constexpr std::chrono::milliseconds kPatience{2000};

    /// Blocks the thread for at most `patience`, and fails if another program holds the lock for so long.
    static Result<FileLock, InputError> take(const std::string &path, std::chrono::milliseconds patience = kPatience);
    ~FileLock();
    FileLock(FileLock &&other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) {}
    FileLock &operator=(FileLock &&) = delete;

private:
    explicit FileLock(int descriptor) : m_descriptor(descriptor) {}
    int m_descriptor;
};

} // namespace skyseal::keys
