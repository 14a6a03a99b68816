#include "app/common/pairing_status.h"

#include "core/base/overloaded.h"
#include "core/base/json_writer.h"
#include "core/engine/text/pairing_text.h"
#include "core/keys/paired_peer.h"
#include "core/keys/public_key_text.h"

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include <array>
#include <utility>

namespace skyseal::app {

namespace {

using State = PairingStatus::State;

struct StateName
{
    State state;
    std::string_view name;
};
constexpr std::array kStateNames{
    StateName{State::Open, "open"},
    StateName{State::Seen, "seen"},
    StateName{State::Confirmed, "confirmed"},
    StateName{State::Other, "other"},
    StateName{State::Differs, "passphrase-differs"},
    StateName{State::Paired, "paired"},
    StateName{State::Over, "over"},
    StateName{State::Refused, "refused"},
};

PairingStatus about(State state, const channel::PairingPeer &peer)
{
    PairingStatus status;
    status.state = state;
    status.name = keys::fitPeerName(peer.name, peer.key);
    status.code = peer.code;
    status.systemId = peer.systemId;
    status.key = peer.key;
    return status;
}

PairingStatus seen(const channel::PairingPeer &peer, const keys::PeersFile &known, const std::string &callIt)
{
    PairingStatus status = about(State::Seen, peer);
    if (!callIt.empty())
        status.name = callIt;
    if (const keys::PeerEntry *same = known.findKey(peer.key)) {
        status.name = same->peer.name;
        status.knownRole = same->peer.role;
    } else if (const keys::PeerEntry *other = known.find(status.name)) {
        status.knownKey = other->peer.key;
        status.knownRole = other->peer.role;
    }
    return status;
}

std::optional<channel::PublicKey> keyIn(const QJsonObject &object, const char *field)
{
    const auto key = keys::publicKeyFromText(object[QLatin1String(field)].toString().toStdString());
    return key ? std::optional(*key) : std::nullopt;
}

} // namespace

std::optional<PairingStatus> statusOf(const channel::PairingEvent &event, const keys::PeersFile &known,
                                      const std::string &callIt)
{
    using Out = std::optional<PairingStatus>;
    const auto plain = [](State state, std::string reason = {}) {
        PairingStatus status;
        status.state = state;
        status.reason = std::move(reason);
        return Out(status);
    };
    return std::visit(
        Overloaded{
            [&](const channel::PairingPeerSeen &e) { return Out(seen(e.peer, known, callIt)); },
            [&](const channel::PairingPeerConfirmed &) { return plain(State::Confirmed); },
            [&](const channel::PairingOtherTried &) { return plain(State::Other); },
            [&](const channel::PairingPassphraseDiffers &) { return plain(State::Differs); },
            [&](const channel::Paired &) { return Out(); },
            [&](const channel::PairingOver &e) { return plain(State::Over, engine::pairingEndText(e.reason).toStdString()); },
        },
        event);
}

std::string PairingStatus::toJson() const
{
    JsonWriter json;
    json.beginObject().field("event", "pairing");
    for (const StateName &candidate : kStateNames) {
        if (candidate.state == state)
            json.field("state", candidate.name);
    }
    if (!name.empty())
        json.field("name", name);
    if (!code.empty())
        json.field("code", code);
    if (systemId != 0)
        json.field("system", std::int32_t{systemId});
    if (role)
        json.field("role", keys::peerRoleText(*role));
    if (key != channel::PublicKey{})
        json.field("public", keys::publicKeyText(key)).field("fingerprint", keys::fingerprint(key));
    if (knownKey)
        json.field("known_public", keys::publicKeyText(*knownKey)).field("known_fingerprint", keys::fingerprint(*knownKey));
    if (knownRole)
        json.field("known_role", keys::peerRoleText(*knownRole));
    if (!reason.empty())
        json.field("reason", reason);
    if (seconds > 0)
        json.field("seconds", std::int32_t{seconds});
    json.endObject();
    return json.text();
}

std::optional<PairingStatus> PairingStatus::fromJson(const QByteArray &line)
{
    const QJsonObject object = QJsonDocument::fromJson(line).object();
    const std::string stateName = object[QLatin1String("state")].toString().toStdString();
    for (const StateName &candidate : kStateNames) {
        if (candidate.name != stateName)
            continue;
        PairingStatus status;
        status.state = candidate.state;
        status.name = object[QLatin1String("name")].toString().toStdString();
        status.code = object[QLatin1String("code")].toString().toStdString();
        status.systemId = static_cast<std::uint8_t>(object[QLatin1String("system")].toInt());
        status.role = keys::peerRoleFromText(object[QLatin1String("role")].toString().toStdString());
        status.key = keyIn(object, "public").value_or(channel::PublicKey{});
        status.knownKey = keyIn(object, "known_public");
        status.knownRole = keys::peerRoleFromText(object[QLatin1String("known_role")].toString().toStdString());
        status.reason = object[QLatin1String("reason")].toString().toStdString();
        status.seconds = object[QLatin1String("seconds")].toInt();
        return status;
    }
    return std::nullopt;
}

} // namespace skyseal::app
