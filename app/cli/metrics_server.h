// Serves the counters of a station by HTTP (RFC 9110, 9112) at /metrics, in the OpenMetrics text format. One answer for each
// connection; nothing else is understood.
#pragma once

#include "core/base/result.h"
#include "core/engine/station/station.h"

#include <QtCore/QObject>
#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>

#include <memory>
#include <string>

namespace skyseal::app {

class MetricsServer : public QObject
{
    Q_OBJECT

public:
    static constexpr int kMostConnections = 16;
    static constexpr qint64 kLongestRequest = 8192;
    /// A connection without a whole request for so long is closed.
    static constexpr std::chrono::seconds kPatience{5};

    /// `station` must outlive this object.
    explicit MetricsServer(engine::Station &station);

    /// `address` is HOST:PORT; without a host, the loopback interface.
    Result<void, InputError> listen(const std::string &address);
    /// Whether listen() understands `address`.
    static bool isAddress(const std::string &address);
    /// Whether others than programs of this machine can read the counters at `address`.
    static bool isOpenToOthers(const std::string &address);
    quint16 port() const { return m_server.serverPort(); }

private:
    void accept();
    void readRequest(QTcpSocket *client);
    QByteArray answerTo(const QByteArray &request) const;

    std::shared_ptr<const engine::Snapshot> m_snapshot;
    QTcpServer m_server;
};

} // namespace skyseal::app
