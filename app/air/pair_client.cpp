#include "app/air/pair_client.h"

#include "app/air/pairing_server.h"
#include "app/common/exit_status.h"
#include "app/common/local_listener.h"
#include "app/common/process.h"
#include "core/base/json_writer.h"
#include "core/crypto/passphrase.h"
#include "core/keys/public_key_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::app {

namespace {

constexpr int kPatienceMs = 2000;

void order(QLocalSocket &socket, const JsonWriter &json)
{
    socket.write(QByteArray::fromStdString(json.text()) + '\n');
    socket.flush();
}

void order(QLocalSocket &socket, std::string_view what)
{
    JsonWriter json;
    json.beginObject().field("do", what).endObject();
    order(socket, json);
}

} // namespace

int runPairClient(const QString &program, const std::string &identityFile, PairingPrompt::Settings settings,
                  const crypto::Passphrase *passphrase)
{
    QLocalSocket socket;
    const QString name = controlSocket(identityFile);
    socket.connectToServer(name);
    if (!socket.waitForConnected(kPatienceMs)) {
        complain(program, name.toStdString() + ": no agent with this identity is running, or it belongs to another user");
        return kCannotOpen;
    }
    if (!isListenerTrusted(socket, identityFile)) {
        complain(program,
                 name.toStdString() + ": the program that listens there belongs to another user; nothing was sent to it");
        return kCannotOpen;
    }
    settings.decidesRole = true;
    settings.hasPassphrase = passphrase != nullptr;
    const std::string callIt = settings.callIt;
    PairingPrompt prompt(std::move(settings));
    QObject::connect(&socket, &QLocalSocket::readyRead, &prompt, [&] {
        while (socket.canReadLine()) {
            if (auto status = PairingStatus::fromJson(socket.readLine()))
                prompt.take(std::move(*status));
        }
    });
    QObject::connect(&socket, &QLocalSocket::disconnected, &prompt, [&] {
        complain(program, "the agent ended");
        QCoreApplication::exit(kNotReached);
    });
    QObject::connect(&prompt, &PairingPrompt::confirmed, &socket, [&](const PairingPrompt::Answer &answer) {
        JsonWriter json;
        json.beginObject().field("do", "confirm").field("public", keys::publicKeyText(answer.key)).field("name", answer.name);
        json.field("role", keys::peerRoleText(answer.role)).field("replace", answer.replace).endObject();
        order(socket, json);
    });
    QObject::connect(&prompt, &PairingPrompt::refused, &socket, [&] { order(socket, "refuse"); });
    // Disconnecting closes the window.
    const auto leave = [&](int status) {
        socket.disconnect(&prompt);
        QCoreApplication::exit(status);
    };
    QObject::connect(&prompt, &PairingPrompt::cancelled, &socket, [&] { leave(kNotReached); });
    QObject::connect(&prompt, &PairingPrompt::finished, &socket, leave);
    StopSignals signals;
    QObject::connect(&signals, &StopSignals::stopRequested, &socket, [&] { leave(kNotReached); });
    const auto length = static_cast<std::int32_t>(passphrase ? passphrase->view().size() : 0);
    JsonWriter open;
    open.beginObject().field("do", "open").field("as", callIt).field("passphrase", length).endObject();
    const auto openIt = [&] {
        order(socket, open);
        if (passphrase) {
            socket.write(reinterpret_cast<const char *>(passphrase->view().data()), length);
            socket.flush();
        }
    };
    // Inside the event loop: if the agent disconnects at once, an exit before the loop starts would have no effect.
    QMetaObject::invokeMethod(&socket, openIt, Qt::QueuedConnection);
    return QCoreApplication::exec();
}

} // namespace skyseal::app
