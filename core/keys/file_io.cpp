#include "core/keys/file_io.h"

#include "core/base/save_file.h"
#include "core/base/secret_bytes.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace skyseal::keys {

namespace {

constexpr ::mode_t kOwnerOnly = 0600;

/// Closes a descriptor at the end of a scope.
class Descriptor
{
public:
    explicit Descriptor(int number) : m_number(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;

    bool isOpen() const { return m_number >= 0; }
    int number() const { return m_number; }
    bool close() { return m_number < 0 || ::close(std::exchange(m_number, -1)) == 0; }

private:
    int m_number;
};

InputError systemError(const std::string &path, const Sentence &what)
{
    return fileError(path, what(std::strerror(errno)));
}

std::string folderOf(const std::string &path)
{
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

/// A new file name is on the disk only after its folder is synced.
void syncFolder(const std::string &path)
{
    const Descriptor folder(::open(folderOf(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.isOpen())
        ::fsync(folder.number()); // some file systems do not support it; then only the rename remains
}

bool writeAll(int descriptor, ByteView content)
{
    while (!content.empty()) {
        const ssize_t count = ::write(descriptor, content.data(), content.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return false;
        content = content.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

std::string octal(mode_t mode)
{
    const auto digit = [mode](int shift) { return static_cast<char>('0' + ((mode >> shift) & 7)); };
    return {'0', digit(6), digit(3), digit(0)};
}

Result<void, InputError> checkAccess(const std::string &path, const struct stat &status, FileAccess access)
{
    if (!S_ISREG(status.st_mode))
        return tl::unexpected(fileError(path, sentence("Reason", "is not a regular file")));
    if (status.st_uid != ::geteuid() && status.st_uid != 0)
        return tl::unexpected(fileError(
            path, sentence("Reason", "belongs to another user (number %1), who can change it, refused")(status.st_uid)));
    const mode_t mode = status.st_mode & 0777;
    if (access == FileAccess::Private && (mode & 077) != 0)
        return tl::unexpected(
            fileError(path, sentence("Reason", "can be read by other users (mode %1), refused; run: chmod 600")(octal(mode))));
    if (access == FileAccess::Trusted && (mode & 022) != 0)
        return tl::unexpected(fileError(
            path, sentence("Reason", "can be changed by other users (mode %1), refused; run: chmod 600")(octal(mode))));
    if (static_cast<std::size_t>(status.st_size) > kMaxFileSize)
        return tl::unexpected(fileError(path, sentence("Reason", "is too large to be a file of this kind")));
    return {};
}

} // namespace

Result<Bytes, InputError> readFile(const std::string &path, FileAccess access)
{
    // Does not block on a pipe in its place, and does not follow a link to another file.
    const int noFollow = access == FileAccess::Private ? O_NOFOLLOW : 0;
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | noFollow));
    if (!file.isOpen()) {
        if (errno == ELOOP && noFollow != 0)
            return tl::unexpected(
                fileError(path, sentence("Reason", "is a symbolic link, refused for a secret; name the file itself")));
        return tl::unexpected(systemError(path, sentence("Reason", "cannot be read: %1")));
    }
    struct stat status
    {};
    if (::fstat(file.number(), &status) != 0)
        return tl::unexpected(systemError(path, sentence("Reason", "cannot be read: %1")));
    if (const auto checked = checkAccess(path, status, access); !checked)
        return tl::unexpected(checked.error());

    // The full capacity at once, so that growing leaves no copies of a secret.
    Bytes content(static_cast<std::size_t>(status.st_size));
    std::size_t size = 0;
    while (size < content.size()) {
        const ssize_t count = ::read(file.number(), content.data() + size, content.size() - size);
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0) {
            wipeSecret(content.data(), content.size());
            return tl::unexpected(systemError(path, sentence("Reason", "cannot be read: %1")));
        }
        if (count == 0)
            break;
        size += static_cast<std::size_t>(count);
    }
    content.resize(size);
    return content;
}

bool fileExists(const std::string &path)
{
    struct stat status
    {};
    return ::lstat(path.c_str(), &status) == 0;
}

Result<void, InputError> createFile(const std::string &path, ByteView content)
{
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kOwnerOnly));
    if (!file.isOpen()) {
        if (errno == EEXIST)
            return tl::unexpected(fileError(path, sentence("Reason", "exists already and is not overwritten")));
        return tl::unexpected(systemError(path, sentence("Reason", "cannot be created: %1")));
    }
    if (!writeAll(file.number(), content) || ::fsync(file.number()) != 0 || !file.close()) {
        const InputError error = systemError(path, sentence("Reason", "cannot be written: %1"));
        ::unlink(path.c_str());
        return tl::unexpected(error);
    }
    syncFolder(path);
    return {};
}

static Result<void, InputError> replace(const std::string &path, ByteView content, ::mode_t mode)
{
    return NewFile::replacing(path, mode).and_then([content](NewFile &&file) {
        file.write(content);
        return file.commit();
    });
}

Result<void, InputError> replaceFile(const std::string &path, ByteView content)
{
    struct stat old
    {};
    return replace(path, content, ::stat(path.c_str(), &old) == 0 ? old.st_mode & 0777 : kOwnerOnly);
}

Result<void, InputError> replaceSecretFile(const std::string &path, ByteView content)
{
    return replace(path, content, kOwnerOnly);
}

Result<FileLock, InputError> FileLock::take(const std::string &path, std::chrono::milliseconds patience)
{
    const std::string name = path + ".lock";
    const int descriptor = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (descriptor < 0)
        return tl::unexpected(systemError(name, sentence("Reason", "cannot be created: %1")));
    FileLock lock(descriptor);
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR)
            return tl::unexpected(systemError(name, sentence("Reason", "cannot be locked: %1")));
        if (std::chrono::steady_clock::now() >= deadline)
            return tl::unexpected(fileError(
                name, sentence("Reason", "is still locked by another program after %1 ms, try again")(patience.count())));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return lock;
}

FileLock::~FileLock()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

} // namespace skyseal::keys
