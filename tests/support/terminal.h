// A pseudo terminal for a program that asks its user something: what the program shows there is collected, answers are typed.
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

    /// Waits until the terminal shows these words; false after 10 s.
    bool waitForText(const QByteArray &words);
    void type(const QByteArray &keys);
    /// The exit status; -1 when it did not end within 20 s.
    int waitForExit();
    /// All that the terminal showed, echoes included.
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
