// The lines on standard input, as they come, from inside the event loop. Lives on the main thread.
#pragma once

#include <QtCore/QByteArray>
#include <QtCore/QObject>
#include <QtCore/QSocketNotifier>

#include <memory>

namespace skyseal::app {

class StdinLines : public QObject
{
    Q_OBJECT

public:
    StdinLines();

Q_SIGNALS:
    /// Without its end.
    void lineRead(const QByteArray &line);

private:
    void read();

    std::unique_ptr<QSocketNotifier> m_notifier; ///< null after the end of the input
    QByteArray m_buffer;
};

} // namespace skyseal::app
