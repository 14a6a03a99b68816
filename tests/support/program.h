// A real program in a test: started with arguments, its JSON lines collected, killed as a crash would.
#pragma once

#include <QtCore/QJsonObject>
#include <QtCore/QProcess>
#include <QtCore/QStringList>

#include <functional>
#include <vector>

namespace skyseal::test {

/// One run of one of our programs (by name, from the build) or of another (by path). Killed when it goes out of scope.
class Program
{
public:
    using Predicate = std::function<bool(const QJsonObject &)>;

    Program(const QString &name, const QStringList &arguments);
    ~Program();
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;

    bool running() const { return m_process.state() == QProcess::Running; }
    qint64 pid() const { return m_process.processId(); }
    /// Waits for an event of this kind that satisfies `predicate` and came after the last one that was waited for; an
    /// empty object when none came within `milliseconds`.
    QJsonObject waitFor(const QString &event, int milliseconds, const Predicate &predicate = {});
    /// Only events that come from now on will be waited for.
    void skipWhatCame();
    /// Waits for the end: the exit status, or -1 when it did not end in time or crashed.
    int waitForExit(int milliseconds);
    /// Writes a line to its standard input.
    void notify(const QString &line);
    /// Asks it to end (SIGTERM) and waits.
    int terminate(int milliseconds = 10000);
    /// kill -9, as the kernel's out-of-memory killer would.
    void kill();

    const std::vector<QJsonObject> &events();
    std::vector<QJsonObject> events(const QString &kind);
    QJsonObject last(const QString &kind);
    /// Everything it wrote to standard error.
    QByteArray errors();
    /// Lines of standard output that were no JSON objects.
    const QByteArrayList &otherLines();

private:
    void drain();

    QProcess m_process;
    QByteArray m_partial;
    QByteArray m_errors;
    QByteArrayList m_otherLines;
    std::vector<QJsonObject> m_events;
    std::size_t m_waitedUpTo = 0;
};

/// A UDP port of 127.0.0.1 that was free a moment ago.
quint16 freeUdpPort();
quint16 freeTcpPort();

} // namespace skyseal::test
