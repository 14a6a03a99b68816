// A pseudo terminal for a program that prompts its user: collects the program's prompts and types the answers.
#pragma once

#include <QtCore/QByteArray>
#include <QtCore/QStringList>

#include <QtCore/QProcess>

namespace skyseal::test {

/// Runs one of our programs (by name) with this as its controlling terminal; its standard output and input are pipes.
class Terminal
{
public:
    Terminal(const QString &program, const QStringList &arguments);
    ~Terminal();
    Terminal(const Terminal &) = delete;
    Terminal &operator=(const Terminal &) = delete;

    /// Waits until the terminal shows this text behind the one found last. Returns false at the deadline.
    bool waitForText(const QByteArray &text);
    void type(const QByteArray &keys);
    /// Waits for the end. Returns the exit status, or -1 if the program crashed or still runs at the deadline.
    int waitForExit();
    /// Everything shown so far, echoes included.
    const QByteArray &shown() const { return m_shown; }
    QByteArray output() { return m_process.readAllStandardOutput(); }
    QByteArray errors() { return m_process.readAllStandardError(); }

private:
    bool readSome(int milliseconds);

    int m_master = -1;
    QProcess m_process;
    QByteArray m_shown;
    qsizetype m_waitedUpTo = 0;
};

} // namespace skyseal::test
