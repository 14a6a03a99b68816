#include "tests/support/program.h"

#include <QtCore/QDeadlineTimer>
#include <QtCore/QCoreApplication>
#include <QtCore/QDir>
#include <QtCore/QJsonDocument>
#include <QtCore/QTimer>
#include <QtTest/QTest>

#include <csignal>
#include <sys/prctl.h>

namespace skyseal::test {

namespace {

/// Reads the pipes of all programs, also of those that the test does not wait for: a full pipe would block a relay.
void turnEventLoop()
{
    QTimer wakeUp;
    wakeUp.start(50);
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

} // namespace

Program::Program(const QString &name, const QStringList &arguments)
{
    const QString path = name.contains(QLatin1Char('/')) ? name : QStringLiteral(SKYSEAL_BIN_DIR "/") + name;
    QObject::connect(&m_process, &QProcess::readyReadStandardOutput, &m_process, [this] { drain(); });
    m_process.setChildProcessModifier(
        [] { ::prctl(PR_SET_PDEATHSIG, SIGKILL); }); // a test that crashes leaves no program running
    m_process.start(path, arguments);
    if (!m_process.waitForStarted(kDeadlineMs))
        qWarning("%s did not start: %s", qPrintable(path), qPrintable(m_process.errorString()));
}

Program::~Program()
{
    if (m_process.state() != QProcess::NotRunning) {
        m_process.kill();
        m_process.waitForFinished(kDeadlineMs);
    }
    drain();
    if (QTest::currentTestFailed() && !m_errors.isEmpty())
        qWarning("%s said:\n%s", qPrintable(m_process.program()), m_errors.constData());
}

void Program::drain()
{
    m_errors += m_process.readAllStandardError();
    m_partial += m_process.readAllStandardOutput();
    for (qsizetype end = m_partial.indexOf('\n'); end >= 0; end = m_partial.indexOf('\n')) {
        const QByteArray line = m_partial.left(end);
        m_partial.remove(0, end + 1);
        const QJsonDocument json = QJsonDocument::fromJson(line);
        if (json.isObject())
            m_events.push_back(json.object());
        else
            m_otherLines.push_back(line);
    }
}

QJsonObject Program::waitFor(const QString &event, const Predicate &predicate, int milliseconds)
{
    const QDeadlineTimer deadline(milliseconds);
    for (;;) {
        const bool ended = m_process.state() == QProcess::NotRunning;
        drain();
        while (m_waitedUpTo < m_events.size()) {
            const QJsonObject &candidate = m_events[m_waitedUpTo++];
            if (candidate[QLatin1String("event")] == event && (!predicate || predicate(candidate)))
                return candidate;
        }
        if (ended || deadline.hasExpired())
            return {};
        turnEventLoop();
    }
}

bool Program::waitUntilListening(const QString &scheme)
{
    return !waitFor(QStringLiteral("link"), [&scheme](const QJsonObject &link) {
                return link[QLatin1String("url")].toString().startsWith(scheme + QLatin1Char(':'))
                    && link[QLatin1String("state")] == QLatin1String("listening");
            }).isEmpty();
}

void Program::skipReceivedEvents()
{
    drain();
    m_waitedUpTo = m_events.size();
}

int Program::waitForExit(int milliseconds)
{
    const QDeadlineTimer deadline(milliseconds);
    while (m_process.state() != QProcess::NotRunning && !deadline.hasExpired()) {
        turnEventLoop();
        drain();
    }
    drain();
    const bool ended = m_process.state() == QProcess::NotRunning && m_process.exitStatus() == QProcess::NormalExit;
    return ended ? m_process.exitCode() : -1;
}

void Program::notify(const QString &line)
{
    m_process.write(line.toUtf8() + '\n');
}

int Program::terminate()
{
    m_process.terminate();
    return waitForExit();
}

void Program::kill()
{
    m_process.kill();
    m_process.waitForFinished(kDeadlineMs);
    drain();
}

const std::vector<QJsonObject> &Program::events()
{
    drain();
    return m_events;
}

std::vector<QJsonObject> Program::events(const QString &kind)
{
    std::vector<QJsonObject> out;
    for (const QJsonObject &event : events()) {
        if (event[QLatin1String("event")] == kind)
            out.push_back(event);
    }
    return out;
}

QJsonObject Program::last(const QString &kind)
{
    const auto all = events(kind);
    return all.empty() ? QJsonObject() : all.back();
}

QByteArray Program::errors()
{
    drain();
    return m_errors;
}

const QByteArrayList &Program::otherLines()
{
    drain();
    return m_otherLines;
}

} // namespace skyseal::test
