// Process setup of every program: keys stay in its memory, and an orderly end on signals.
#pragma once

#include <QtCore/QObject>

namespace skyseal::app {

/// Keeps the keys in memory from core files, and from other processes of the same user; reports once, on stderr, if they cannot
/// be kept from the swap space. Call first in main(). To debug a program, start it under the debugger: attaching to it, and
/// reading its /proc files, takes CAP_SYS_PTRACE.
void protectKeysInMemory();

/// Converts SIGINT, SIGTERM and SIGHUP (a terminal that is closed) into a Qt signal; a second SIGINT or SIGTERM ends the
/// process at once. SIGHUP stays ignored in a program that was started so.
class StopSignals : public QObject
{
    Q_OBJECT

public:
    explicit StopSignals(QObject *parent = nullptr);
    ~StopSignals() override;

    /// From now on SIGHUP is a request to read the configuration again.
    void takeReload();

Q_SIGNALS:
    void stopRequested();
    void reloadRequested();

private:
    int m_pipe[2] = {-1, -1};
};

} // namespace skyseal::app
