// Ports of 127.0.0.1 for programs that a test starts.
#pragma once

#include <QtCore/QtGlobal>

namespace skyseal::test {

/// Returns a port on which nothing listens. No other caller gets it while this process lives, in any test that runs beside
/// it, and the system gives it to no socket that asks for any port. So a program may bind it later, and once more.
quint16 freeUdpPort();
quint16 freeTcpPort();

} // namespace skyseal::test
