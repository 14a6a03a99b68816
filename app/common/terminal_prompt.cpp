#include "app/common/terminal_prompt.h"

#include "core/base/printable.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/passphrase.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace skyseal::app {

using crypto::Passphrase;

namespace {

constexpr unsigned char kInterrupt = 3; // Ctrl+C

/// Switches the echo off while it lives. Signals are blocked until the terminal is restored: a process that is stopped or ended
/// before would leave the shell without echo.
class SilentTerminal
{
public:
    SilentTerminal() : m_descriptor(::open("/dev/tty", O_RDWR | O_CLOEXEC))
    {
        if (m_descriptor < 0 || ::tcgetattr(m_descriptor, &m_before) != 0)
            return;
        sigset_t waiting;
        sigemptyset(&waiting);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP})
            sigaddset(&waiting, signal);
        ::pthread_sigmask(SIG_BLOCK, &waiting, &m_signals);
        termios silent = m_before;
        // Ctrl+C ends the line instead of the program, so that it can be handled here.
        silent.c_lflag &= ~static_cast<tcflag_t>(ECHO | ECHOE | ECHOK | ECHONL | ISIG);
        silent.c_lflag |= ICANON;
        silent.c_cc[VEOL] = kInterrupt;
        m_changed = ::tcsetattr(m_descriptor, TCSAFLUSH, &silent) == 0;
        if (!m_changed)
            ::pthread_sigmask(SIG_SETMASK, &m_signals, nullptr);
    }
    ~SilentTerminal()
    {
        if (m_changed) {
            ::tcsetattr(m_descriptor, TCSAFLUSH, &m_before);
            ::pthread_sigmask(SIG_SETMASK, &m_signals, nullptr);
        }
        if (m_descriptor >= 0)
            ::close(m_descriptor);
    }
    SilentTerminal(const SilentTerminal &) = delete;
    SilentTerminal &operator=(const SilentTerminal &) = delete;

    bool isReady() const { return m_changed; }
    int descriptor() const { return m_descriptor; }
    void say(const std::string &text) const
    {
        // A terminal that cannot be written to shows no question.
        [[maybe_unused]] const ssize_t written = ::write(m_descriptor, text.data(), text.size());
    }

private:
    int m_descriptor;
    bool m_changed = false;
    termios m_before{};
    sigset_t m_signals{};
};

} // namespace

Result<Passphrase, InputError> askAtTerminal(const std::string &question, const std::string &source, const std::string &which)
{
    const SilentTerminal terminal;
    if (!terminal.isReady())
        return tl::unexpected(InputError{"there is no terminal to ask for the passphrase; use --" + which
                                             + "passphrase-file or --" + which + "passphrase-fd",
                                         source});
    terminal.say(printable(question));
    SecretBytes<4096> line; // the longest line of a terminal
    ssize_t size = -1;
    do
        size = ::read(terminal.descriptor(), line.mutableView().data(), line.size());
    while (size < 0 && errno == EINTR);
    terminal.say("\n");
    if (size < 0)
        return tl::unexpected(InputError{std::string("the terminal cannot be read: ") + std::strerror(errno), source});
    ByteView typed = ByteView(line.view()).first(static_cast<std::size_t>(size));
    if (typed.empty() || typed.back() == kInterrupt)
        return tl::unexpected(InputError{"cancelled", source});
    if (typed.back() == '\n')
        typed = typed.first(typed.size() - 1);
    auto passphrase = Passphrase::fromBytes(typed);
    if (!passphrase)
        return tl::unexpected(
            InputError{typed.empty() ? "no passphrase was entered" : "the passphrase has more than 1024 bytes", source});
    return std::move(*passphrase);
}

} // namespace skyseal::app
