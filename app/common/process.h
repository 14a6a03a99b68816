// What every program does for its own process: no core dumps (they would hold keys), and an orderly end when asked.
#pragma once

#include <QtCore/QObject>

namespace skyseal::app {

/// Keys live in this process's memory: neither a core file nor another process of the same user shall see them.
void forbidCoreDumps();

/// SIGINT and SIGTERM as a signal of Qt's. A second one ends the process at once.
class StopSignals : public QObject
{
    Q_OBJECT

public:
    explicit StopSignals(QObject *parent = nullptr);
    ~StopSignals() override;

Q_SIGNALS:
    void stopRequested();

private:
    int m_pipe[2] = {-1, -1};
};

} // namespace skyseal::app
