// Two pseudo-terminals joined like serial ports by a null modem cable: bytes written to one device are read from the other.
// Runs in the test's event loop. Linux.
#pragma once

#include "tests/support/eventually.h"

#include <QtCore/QSocketNotifier>
#include <QtCore/QString>

#include <array>
#include <cstdlib>
#include <functional>
#include <memory>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace skyseal::test {

class NullModem
{
public:
    NullModem()
    {
        for (std::size_t end = 0; end < 2; ++end) {
            const int fd = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
            if (fd < 0 || ::grantpt(fd) != 0 || ::unlockpt(fd) != 0)
                qFatal("no pseudo-terminal");
            // Keep both devices open from the start: a terminal that no process has open discards its input.
            m_masters[end] = fd;
            m_slaves[end] = ::open(::ptsname(fd), O_RDWR | O_NOCTTY);
            termios raw{};
            ::tcgetattr(m_slaves[end], &raw);
            ::cfmakeraw(&raw);
            ::tcsetattr(m_slaves[end], TCSANOW, &raw);
        }
        for (std::size_t end = 0; end < 2; ++end) {
            m_notifiers[end] = std::make_unique<QSocketNotifier>(m_masters[end], QSocketNotifier::Read);
            QSocketNotifier *const notifier = m_notifiers[end].get();
            QObject::connect(notifier, &QSocketNotifier::activated, notifier, [this, end] { carry(end); });
        }
    }
    ~NullModem()
    {
        for (std::size_t end = 0; end < 2; ++end) {
            m_notifiers[end].reset();
            ::close(m_slaves[end]);
            ::close(m_masters[end]);
        }
    }
    NullModem(const NullModem &) = delete;
    NullModem &operator=(const NullModem &) = delete;

    QString device(std::size_t end) const { return QString::fromLocal8Bit(::ptsname(m_masters[end])); }

    std::array<std::uint64_t, 2> carried{}; ///< bytes, by the end that wrote them
    /// Called with the bytes written at one end; may change them.
    std::function<void(std::size_t from, std::array<char, 4096> &bytes, std::size_t size)> noise;

private:
    void carry(std::size_t from)
    {
        std::array<char, 4096> bytes;
        const ssize_t size = ::read(m_masters[from], bytes.data(), bytes.size());
        if (size <= 0)
            return;
        carried[from] += static_cast<std::uint64_t>(size);
        if (noise)
            noise(from, bytes, static_cast<std::size_t>(size));
        for (ssize_t at = 0; at < size;) {
            const ssize_t done = ::write(m_masters[1 - from], bytes.data() + at, static_cast<std::size_t>(size - at));
            if (done > 0) {
                at += done;
                continue;
            }
            pollfd room{m_masters[1 - from], POLLOUT, 0}; // until the program at the other end has read
            if (::poll(&room, 1, kDeadlineMs) <= 0 || !(room.revents & POLLOUT))
                return;
        }
    }

    std::array<int, 2> m_masters{-1, -1}, m_slaves{-1, -1};
    std::array<std::unique_ptr<QSocketNotifier>, 2> m_notifiers;
};

} // namespace skyseal::test
