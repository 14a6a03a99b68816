// The event loop of programs and threads without a window. On Linux an EpollDispatcher, elsewhere Qt's own.
#pragma once

class QThread;

namespace skyseal::link {

/// For the main thread. Call before QCoreApplication is made.
void installEventLoop();
/// Call before the thread is started.
void installEventLoop(QThread &thread);

} // namespace skyseal::link
