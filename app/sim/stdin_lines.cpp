#include "app/sim/stdin_lines.h"

#include <array>
#include <cerrno>

#include <unistd.h>

namespace skyseal::app {

namespace {

constexpr qsizetype kLongestLine = 4096; // nothing that is understood is as long

} // namespace

StdinLines::StdinLines() : m_notifier(std::make_unique<QSocketNotifier>(STDIN_FILENO, QSocketNotifier::Read))
{
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &StdinLines::read);
}

void StdinLines::read()
{
    std::array<char, 512> bytes{};
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN))
        return;
    if (count <= 0) {
        m_notifier->setEnabled(false);
        return;
    }
    m_buffer.append(bytes.data(), static_cast<qsizetype>(count));
    for (qsizetype end = m_buffer.indexOf('\n'); end >= 0; end = m_buffer.indexOf('\n')) {
        const QByteArray line = m_buffer.left(end).trimmed();
        m_buffer.remove(0, end + 1);
        Q_EMIT lineRead(line);
    }
    if (m_buffer.size() > kLongestLine)
        m_buffer.clear();
}

} // namespace skyseal::app

#include "moc_stdin_lines.cpp"
