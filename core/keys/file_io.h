// Small files read and replaced with care: who may read them is checked on the open descriptor, and a reader never sees
// half of a new version, whatever is killed when.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <string>
#include <utility>

namespace skyseal::keys {

/// Who else may touch a file that we are willing to read. It must be our own or the superuser's.
enum class FileAccess {
    Private, ///< nobody else may read it, and it is no symbolic link: private keys
    Trusted, ///< nobody else may write it: whom we trust
};

/// Larger files are none of ours.
inline constexpr std::size_t kMaxFileSize = 1 << 20;

inline InputError fileError(const std::string &path, std::string message, std::size_t line = 0)
{
    return {std::move(message), path, line, 0};
}

/// The whole file. The caller wipes it when it is secret.
Result<Bytes, InputError> readFile(const std::string &path, FileAccess access);
bool fileExists(const std::string &path);

/// Creates a file that must not exist yet, readable by the owner alone, and makes sure that it is on the disk.
Result<void, InputError> createFile(const std::string &path, ByteView content);

/// Replaces a file as a whole, or creates it: written beside it, synced, renamed. Keeps the permissions of the old one; a
/// new one is for the owner alone.
Result<void, InputError> replaceFile(const std::string &path, ByteView content);
/// The same for a secret: afterwards it is for the owner alone, whoever could read the old one.
Result<void, InputError> replaceSecretFile(const std::string &path, ByteView content);

/// Locks across processes, for as long as it lives, the right to change a file. The lock is the file `path`.lock.
class FileLock
{
public:
    static Result<FileLock, InputError> take(const std::string &path);
    ~FileLock();
    FileLock(FileLock &&other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) {}
    FileLock &operator=(FileLock &&) = delete;

private:
    explicit FileLock(int descriptor) : m_descriptor(descriptor) {}
    int m_descriptor;
};

} // namespace skyseal::keys
