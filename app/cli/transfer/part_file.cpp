#include "app/cli/transfer/part_file.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace skyseal::app {

namespace {

/// A journal is larger than what it keeps, by ten bytes a piece.
constexpr std::size_t kMostJournal = vehicle::KeptPart::kMostBytes / 4 * 5;

} // namespace

PartFile::PartFile(const std::string &file, std::string source) : m_path(file + ".part"), m_source(std::move(source))
{
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    m_isUsed = (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status))
        && m_source.find('\n') == std::string::npos;
}

PartFile::~PartFile()
{
    close();
}

std::shared_ptr<const vehicle::KeptPart> PartFile::resume()
{
    if (!m_isUsed || !open(0))
        return nullptr;
    auto part = vehicle::parsePart(read());
    if (!part) { // somebody else's
        close();
        m_isUsed = false;
        return nullptr;
    }
    if (part->source != m_source || part->pieces.empty())
        return nullptr;
    const auto end = static_cast<off_t>(part->journalSize);
    if (::ftruncate(m_descriptor, end) != 0 || ::lseek(m_descriptor, end, SEEK_SET) != end)
        return nullptr;
    return std::make_shared<const vehicle::KeptPart>(std::move(*part));
}

void PartFile::remove()
{
    if (isOpen())
        ::unlink(m_path.c_str());
    close();
}

void PartFile::begin(std::uint32_t size, std::uint32_t stamp)
{
    if (!m_isUsed || (!isOpen() && !open(O_CREAT | O_EXCL)))
        return;
    if (::ftruncate(m_descriptor, 0) == 0 && ::lseek(m_descriptor, 0, SEEK_SET) == 0)
        write(asBytes(vehicle::partHeader(m_source, size, stamp)));
}

void PartFile::append(std::uint32_t offset, ByteView bytes)
{
    if (isOpen())
        write(vehicle::partPiece(offset, bytes));
}

/// Opens the journal. Returns false if there is none, or another program has it.
bool PartFile::open(int flags)
{
    m_descriptor = ::open(m_path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | flags, 0666);
    if (!isOpen()) {
        m_isUsed = errno == ENOENT;
        return false;
    }
    if (::flock(m_descriptor, LOCK_EX | LOCK_NB) == 0)
        return true;
    close();
    m_isUsed = false;
    return false;
}

void PartFile::close()
{
    if (isOpen())
        ::close(std::exchange(m_descriptor, -1));
}

Bytes PartFile::read() const
{
    const off_t size = ::lseek(m_descriptor, 0, SEEK_END);
    if (size < 0 || static_cast<std::size_t>(size) > kMostJournal)
        return {};
    Bytes out(static_cast<std::size_t>(size));
    std::size_t done = 0;
    while (done < out.size()) {
        const ssize_t count = ::pread(m_descriptor, out.data() + done, out.size() - done, static_cast<off_t>(done));
        if (count <= 0 && errno != EINTR)
            break;
        done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    out.resize(done);
    return out;
}

/// After a failure the journal ends; the piece that is not whole is not read again.
void PartFile::write(ByteView bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = ::write(m_descriptor, bytes.data(), bytes.size());
        if (count > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            close();
            m_isUsed = false;
            return;
        }
    }
}

} // namespace skyseal::app
