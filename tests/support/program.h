// A program that runs beside the test: started with arguments, its JSON lines are collected, and it can be killed.
#pragma once

#include "tests/support/eventually.h"
#include "tests/support/free_port.h"

#include <QtCore/QJsonObject>
#include <QtCore/QProcess>
#include <QtCore/QStringList>

#include <functional>
#include <vector>

namespace skyseal::test {

/// One run of a program of the build (by name) or of another program (by path). The destructor kills it.
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
    /// Waits for the next event of this kind that satisfies `predicate`, among those after the last event returned. Returns
    /// an empty object if the program ends or `milliseconds` pass without one: pass the time only to show that none comes.
    QJsonObject waitFor(const QString &event, const Predicate &predicate = {}, int milliseconds = kDeadlineMs);
    /// Waits until a link of this scheme ("tcpin") accepts connections.
    bool waitUntilListening(const QString &scheme);
    /// Lets waitFor() ignore the events received so far.
    void skipReceivedEvents();
    /// Waits for the end. Returns the exit status, or -1 if the program crashed or still runs. Pass the time only for a program
    /// that runs longer than kDeadlineMs.
    int waitForExit(int milliseconds = kDeadlineMs);
    /// Writes a line to its standard input.
    void notify(const QString &line);
    /// Sends SIGTERM and waits for the end. Returns like waitForExit().
    int terminate();
    /// kill -9, as the kernel's out-of-memory killer would.
    void kill();

    const std::vector<QJsonObject> &events();
    std::vector<QJsonObject> events(const QString &kind);
    QJsonObject last(const QString &kind);
    /// Everything written to standard error so far.
    QByteArray errors();
    /// Lines of standard output that are not JSON objects.
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

} // namespace skyseal::test
