// The commands of skyseal-cli. Each takes its arguments and returns the exit status.
#pragma once

#include <QtCore/QStringList>

namespace skyseal::app {

int runMonitor(const QStringList &arguments);
int runGateway(const QStringList &arguments);
int runStatus(const QStringList &arguments);
int runSwitch(const QStringList &arguments);
int runRevoke(const QStringList &arguments);
int runParam(const QStringList &arguments);
int runMission(const QStringList &arguments);
int runFence(const QStringList &arguments);
int runRally(const QStringList &arguments);
int runFtp(const QStringList &arguments);
int runLogs(const QStringList &arguments);
int runDecode(const QStringList &arguments);
int runImpair(const QStringList &arguments);
int runKeys(const QStringList &arguments);
int runLog(const QStringList &arguments);
int runSweep(const QStringList &arguments);
int runReport(const QStringList &arguments);
int runBench(const QStringList &arguments);
int runSelfTest(const QStringList &arguments);

} // namespace skyseal::app
