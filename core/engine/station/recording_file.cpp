#include "core/engine/station/recording_file.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace skyseal::engine {

bool RecordingFile::create(const std::string &name)
{
    close();
    m_name = name;
    m_size = 0;
    // Readable by the owner only: the file contains in clear the data that the link protects, such as positions.
    m_descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    return isOpen();
}

bool RecordingFile::append(ByteView bytes)
{
    const std::uint64_t after = m_size + bytes.size();
    while (!bytes.empty()) {
        const ssize_t done = ::write(m_descriptor, bytes.data(), bytes.size());
        if (done < 0 && errno == EINTR)
            continue;
        if (done <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(done));
    }
    m_size = after;
    return true;
}

void RecordingFile::sync()
{
    if (isOpen())
        fdatasync(m_descriptor);
}

void RecordingFile::close()
{
    sync();
    if (isOpen())
        ::close(std::exchange(m_descriptor, -1));
}

void RecordingFile::closeAfterError()
{
    if (!isOpen())
        return;
    if (m_size == 0)
        unlink(m_name.c_str());
    else
        static_cast<void>(ftruncate(m_descriptor, static_cast<off_t>(m_size)) == 0);
    ::close(std::exchange(m_descriptor, -1));
}

} // namespace skyseal::engine
