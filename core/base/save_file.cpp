#include "core/base/save_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <random>
#include <sys/stat.h>
#include <unistd.h>

namespace skyseal {

namespace {

constexpr int kMostLinks = 40;    // as the kernel
constexpr int kMostAttempts = 20; // at a name that is not taken

/// The file that the symbolic link at `path` names, also if it does not exist yet.
std::string followed(const std::string &path)
{
    std::filesystem::path out = path;
    std::error_code error;
    for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(out, error); ++i)
        out = out.parent_path() / std::filesystem::read_symlink(out, error);
    return out.string();
}

/// A new file name is on the disk only after its folder is synced.
void syncFolder(const std::string &path)
{
    const std::string folder = std::filesystem::path(path).parent_path().string();
    const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    ::fsync(descriptor); // some file systems do not support it; then only the rename remains
    ::close(descriptor);
}

} // namespace

NewFile::NewFile(NewFile &&other) noexcept
    : m_path(std::move(other.m_path)), m_temporary(std::exchange(other.m_temporary, {})),
      m_descriptor(std::exchange(other.m_descriptor, -1)), m_error(other.m_error)
{}

NewFile::~NewFile()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
    if (!m_temporary.empty())
        ::unlink(m_temporary.c_str());
}

Result<NewFile, InputError> NewFile::replacing(std::string path, ::mode_t mode)
{
    NewFile out(std::move(path));
    if (!out.create(mode))
        return tl::unexpected(out.error());
    return out;
}

Result<NewFile, InputError> NewFile::saving(std::string path)
{
    NewFile out(std::move(path));
    struct stat old
    {};
    const bool exists = ::stat(out.m_path.c_str(), &old) == 0;
    if (exists && S_ISDIR(old.st_mode)) {
        errno = EISDIR;
        out.fail();
    } else if (exists && ::access(out.m_path.c_str(), W_OK) != 0) { // as for a program that writes into the old file
        out.fail();
    } else if (!exists || S_ISREG(old.st_mode)) {
        out.m_path = followed(out.m_path);
        out.create(exists ? std::optional<::mode_t>(old.st_mode & 0777) : std::nullopt);
    }
    if (out.m_error != 0)
        return tl::unexpected(out.error());
    return out;
}

/// Creates the temporary file. Without `mode` its permissions are those of any new file.
bool NewFile::create(std::optional<::mode_t> mode)
{
    std::random_device random;
    for (int i = 0; i < kMostAttempts && m_descriptor < 0; ++i) {
        m_temporary = m_path + '.' + std::to_string(random());
        m_descriptor = ::open(m_temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode ? 0600 : 0666);
        if (m_descriptor < 0 && errno != EEXIST)
            break;
    }
    if (m_descriptor < 0) {
        m_temporary.clear(); // not ours
        return fail();
    }
    return !mode || ::fchmod(m_descriptor, *mode) == 0 || fail();
}

bool NewFile::write(ByteView bytes)
{
    if (m_error == 0 && m_descriptor < 0 && (m_descriptor = ::open(m_path.c_str(), O_WRONLY | O_CLOEXEC)) < 0)
        return fail();
    while (m_error == 0 && !bytes.empty()) {
        const ssize_t count = ::write(m_descriptor, bytes.data(), bytes.size());
        if (count > 0)
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        else if (count == 0 || errno != EINTR)
            fail();
    }
    return m_error == 0;
}

Result<void, InputError> NewFile::commit()
{
    if (m_error == 0 && !m_temporary.empty() && ::fsync(m_descriptor) != 0)
        fail();
    if (m_descriptor >= 0 && ::close(std::exchange(m_descriptor, -1)) != 0)
        fail();
    if (m_error == 0 && !m_temporary.empty()) {
        if (::rename(m_temporary.c_str(), m_path.c_str()) == 0) {
            m_temporary.clear();
            syncFolder(m_path);
        } else {
            fail();
        }
    }
    if (m_error != 0)
        return tl::unexpected(error());
    return {};
}

/// Notes errno, of the first failure.
bool NewFile::fail()
{
    if (m_error == 0)
        m_error = errno;
    return false;
}

InputError NewFile::error() const
{
    return {sentence("Reason", "cannot be written: %1")(std::strerror(m_error)), m_path, 0, 0};
}

Result<void, InputError> saveFile(std::string path, ByteView content)
{
    return NewFile::saving(std::move(path)).and_then([content](NewFile &&file) {
        file.write(content);
        return file.commit();
    });
}

} // namespace skyseal
