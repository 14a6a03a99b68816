#include "tests/support/terminal.h"

#include "tests/support/eventually.h"

#include <QtCore/QDeadlineTimer>

#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace skyseal::test {

Terminal::Terminal(const QString &program, const QStringList &arguments)
    : m_master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC))
{
    if (m_master < 0 || ::grantpt(m_master) != 0 || ::unlockpt(m_master) != 0)
        return;
    const QByteArray name = ::ptsname(m_master);
    m_process.setChildProcessModifier([name] {
        ::setsid();
        const int terminal = ::open(name.constData(), O_RDWR | O_CLOEXEC); // the first one that a session's leader opens
        ::ioctl(terminal, TIOCSCTTY, 0);
    });
    m_process.start(QStringLiteral(SKYSEAL_BIN_DIR "/") + program, arguments);
    m_process.waitForStarted(kDeadlineMs);
}

Terminal::~Terminal()
{
    if (m_process.state() != QProcess::NotRunning) {
        m_process.kill();
        m_process.waitForFinished(kDeadlineMs);
    }
    if (m_master >= 0)
        ::close(m_master);
}

bool Terminal::readSome(int milliseconds)
{
    pollfd ready{m_master, POLLIN, 0};
    if (::poll(&ready, 1, milliseconds) <= 0 || !(ready.revents & POLLIN))
        return false;
    char bytes[256];
    const ssize_t count = ::read(m_master, bytes, sizeof bytes);
    if (count > 0)
        m_shown.append(bytes, count);
    return count > 0;
}

bool Terminal::waitForText(const QByteArray &text)
{
    for (const QDeadlineTimer deadline(kDeadlineMs); !deadline.hasExpired(); readSome(100)) {
        const qsizetype at = m_shown.indexOf(text, m_waitedUpTo);
        if (at >= 0) {
            m_waitedUpTo = at + text.size();
            return true;
        }
    }
    return false;
}

void Terminal::type(const QByteArray &keys)
{
    [[maybe_unused]] const ssize_t written = ::write(m_master, keys.constData(), static_cast<std::size_t>(keys.size()));
}

int Terminal::waitForExit()
{
    const bool ended = m_process.state() == QProcess::NotRunning || m_process.waitForFinished(kDeadlineMs);
    while (readSome(0)) {}
    return ended && m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -1;
}

} // namespace skyseal::test
