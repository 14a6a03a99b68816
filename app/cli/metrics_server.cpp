#include "app/cli/metrics_server.h"

#include "core/engine/headless/open_metrics.h"
#include "core/link/address_text.h"

#include <QtCore/QTimer>

namespace skyseal::app {

namespace {

QByteArray response(const char *status, const char *type, const QByteArray &content)
{
    return QByteArray("HTTP/1.1 ") + status + "\r\nContent-Type: " + type
        + "\r\nContent-Length: " + QByteArray::number(content.size()) + "\r\nConnection: close\r\n\r\n" + content;
}

/// Without a host, the loopback interface.
std::optional<Address> parsed(const std::string &address)
{
    return link::parseAddress(address.starts_with(':') ? "127.0.0.1" + address : address);
}

} // namespace

MetricsServer::MetricsServer(engine::Station &station)
{
    connect(&station, &engine::Station::snapshotReady, this,
            [this](const std::shared_ptr<const engine::Snapshot> &snapshot) { m_snapshot = snapshot; });
    connect(&m_server, &QTcpServer::newConnection, this, [this] { accept(); });
}

bool MetricsServer::isAddress(const std::string &address)
{
    return parsed(address).has_value();
}

bool MetricsServer::isOpenToOthers(const std::string &address)
{
    const auto named = parsed(address);
    return named && !link::toQt(*named).isLoopback();
}

Result<void, InputError> MetricsServer::listen(const std::string &address)
{
    const auto named = parsed(address);
    if (!named)
        return tl::unexpected(InputError{"an address and a port are expected, such as 127.0.0.1:9464", address});
    if (!m_server.listen(link::toQt(*named), named->port))
        return tl::unexpected(InputError{m_server.errorString().toStdString(), address});
    return {};
}

void MetricsServer::accept()
{
    while (QTcpSocket *client = m_server.nextPendingConnection()) {
        connect(client, &QTcpSocket::disconnected, client, &QObject::deleteLater);
        if (m_server.findChildren<QTcpSocket *>(QString(), Qt::FindDirectChildrenOnly).size() > kMostConnections) {
            client->abort();
            continue;
        }
        client->setReadBufferSize(kLongestRequest);
        connect(client, &QTcpSocket::readyRead, this, [this, client] { readRequest(client); });
        QTimer::singleShot(kPatience, client, [client] { client->abort(); });
    }
}

void MetricsServer::readRequest(QTcpSocket *client)
{
    const QByteArray request = client->peek(kLongestRequest);
    if (!request.contains("\r\n\r\n") && request.size() < kLongestRequest)
        return; // more follows
    client->readAll();
    client->disconnect(this);
    client->write(answerTo(request));
    client->disconnectFromHost();
}

QByteArray MetricsServer::answerTo(const QByteArray &request) const
{
    const QByteArrayList line = request.left(request.indexOf('\r')).split(' ');
    if (line.size() != 3 || !line[2].startsWith("HTTP/1."))
        return response("400 Bad Request", "text/plain", "a request of HTTP/1.1 is expected\n");
    if (line[0] != "GET" && line[0] != "HEAD")
        return response("405 Method Not Allowed", "text/plain", "GET is expected\n");
    if (line[1] != "/metrics")
        return response("404 Not Found", "text/plain", "the metrics are at /metrics\n");
    if (!m_snapshot)
        return response("503 Service Unavailable", "text/plain", "not started yet\n");
    const QByteArray answer = response("200 OK", engine::kOpenMetricsType,
                                       QByteArray::fromStdString(engine::openMetrics(*m_snapshot)));
    return line[0] == "HEAD" ? answer.left(answer.indexOf("\r\n\r\n") + 4) : answer;
}

} // namespace skyseal::app

#include "moc_metrics_server.cpp"
