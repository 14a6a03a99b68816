// skyseal-cli status, switch and revoke: act on a running gateway, through its control socket.
#include "app/cli/commands.h"
#include "app/cli/control/control_url.h"
#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "core/channel/timing.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtNetwork/QLocalSocket>

namespace skyseal::app {

namespace {

/// Longer than a switch that is not confirmed takes to roll back.
constexpr std::chrono::milliseconds kPatience = std::chrono::duration_cast<std::chrono::milliseconds>(
                                                    channel::Timing().switchConfirm)
    + std::chrono::seconds(5);

/// The answer to a request; the error is a sentence.
Result<QJsonObject, std::string> ask(const QString &path, const QJsonObject &request)
{
    QLocalSocket socket;
    socket.connectToServer(path);
    const int patience = static_cast<int>(kPatience.count());
    if (!socket.waitForConnected(patience))
        return tl::unexpected(path.toStdString()
                              + (socket.error() == QLocalSocket::SocketAccessError
                                     ? ": this user has no permission to open it; only the user of the gateway has"
                                     : ": no gateway listens there"));
    socket.write(QJsonDocument(request).toJson(QJsonDocument::Compact) + '\n');
    QElapsedTimer clock;
    clock.start();
    while (!socket.canReadLine() && clock.elapsed() < patience) {
        if (!socket.waitForReadyRead(patience - static_cast<int>(clock.elapsed())))
            break;
    }
    const QJsonDocument answer = QJsonDocument::fromJson(socket.readLine());
    if (!answer.isObject())
        return tl::unexpected(path.toStdString() + ": the gateway does not answer");
    return answer.object();
}

void declareRequestOptions(Options &options)
{
    declareControl(options, "Control socket of the gateway.");
    options.addFlag("json", "Print the answer as one JSON object.");
}

/// `print` shows the answer to people.
template<typename Print> int request(const QString &name, Options &options, const QJsonObject &content, Print print)
{
    options.required("control");
    const QString path = readControl(options);
    if (const auto status = options.finish())
        return *status;
    const auto answer = ask(path, content);
    if (!answer) {
        complain(name, answer.error());
        return kCannotOpen;
    }
    const bool ok = answer->value(QStringLiteral("ok")).toBool();
    if (options.has("json"))
        printLine(QJsonDocument(*answer).toJson(QJsonDocument::Compact).toStdString());
    else if (ok)
        print(*answer);
    else
        complain(name, answer->value(QStringLiteral("error")).toString().toStdString());
    return ok ? kDone : kNotReached;
}

} // namespace

int runStatus(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli status");
    Options options(name, QStringLiteral("Shows the state of a running gateway."));
    declareRequestOptions(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    return request(name, options, {{QStringLiteral("request"), QStringLiteral("status")}}, [](const QJsonObject &answer) {
        for (const QJsonValueConstRef line : answer.value(QStringLiteral("text")).toArray())
            printLine(line.toString().toStdString());
    });
}

int runSwitch(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli switch");
    Options options(name, QStringLiteral("Switches all sessions of a running gateway to another suite."));
    options.addArgument("SUITE", "Name of the suite.");
    declareRequestOptions(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QString suite = options.arguments(1, 1).value(0);
    const QJsonObject content{{QStringLiteral("request"), QStringLiteral("switch")}, {QStringLiteral("suite"), suite}};
    return request(name, options, content, [&suite](const QJsonObject &answer) {
        const int sessions = answer.value(QStringLiteral("sessions")).toInt();
        printLine((sessions == 1 ? "one session uses " : std::to_string(sessions) + " sessions use ") + suite.toStdString());
    });
}

int runRevoke(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli revoke");
    Options options(name, QStringLiteral("Removes a peer from the list of a running gateway; its sessions end at once."));
    options.addArgument("PEER", "Name of the peer.");
    declareRequestOptions(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QString peer = options.arguments(1, 1).value(0);
    const QJsonObject content{{QStringLiteral("request"), QStringLiteral("revoke")}, {QStringLiteral("peer"), peer}};
    return request(name, options, content, [&peer](const QJsonObject &) { printLine("removed " + peer.toStdString()); });
}

} // namespace skyseal::app
