// Process setup of every program: no core dumps (they would contain keys), and an orderly end on signals.
#pragma once

#include <QtCore/QObject>

namespace skyseal::app {

/// Protects the keys in memory from core files and from other processes of the same user.
void forbidCoreDumps();

/// Converts SIGINT and SIGTERM into a Qt signal. A second one ends the process at once.
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
