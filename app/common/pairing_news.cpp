#include "app/common/pairing_news.h"

#include "app/common/overloaded.h"
#include "core/base/json_writer.h"
#include "core/keys/paired_peer.h"
#include "core/keys/public_key_text.h"

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include <array>

namespace skyseal::app {

namespace {

using State = PairingNews::State;

struct StateWord
{
    State state;
    std::string_view word;
};
constexpr std::array kWords{
    StateWord{State::Open, "open"},       StateWord{State::Seen, "seen"},       StateWord{State::Confirmed, "confirmed"},
    StateWord{State::Gone, "gone"},       StateWord{State::Other, "other"},     StateWord{State::Differs, "passphrase-differs"},
    StateWord{State::Paired, "paired"},   StateWord{State::Over, "over"},       StateWord{State::Refused, "refused"},
};

const char *words(channel::PairingGone reason)
{
    switch (reason) {
    case channel::PairingGone::Silent: return "it fell silent";
    case channel::PairingGone::Refused: return "the other end said no";
    case channel::PairingGone::Replaced: return "it began again";
    }
    return "";
}

const char *words(channel::PairingEnd reason)
{
    switch (reason) {
    case channel::PairingEnd::Paired: return "";
    case channel::PairingEnd::TimedOut: return "the time is over";
    case channel::PairingEnd::Cancelled: return "cancelled";
    case channel::PairingEnd::Armed: return "the vehicle was armed";
    }
    return "";
}

PairingNews about(State state, const channel::PairingPeer &peer)
{
    PairingNews news;
    news.state = state;
    news.name = keys::fitPeerName(peer.name, peer.key);
    news.role = peer.roleAsked;
    news.key = peer.key;
    return news;
}

PairingNews seen(const channel::PairingPeer &peer, const keys::PeersFile &known, const std::string &callIt)
{
    PairingNews news = about(State::Seen, peer);
    if (!callIt.empty())
        news.name = callIt;
    if (const keys::PeerEntry *same = known.findKey(peer.key)) {
        news.name = same->peer.name;
        news.knownRole = same->peer.role;
    } else if (const keys::PeerEntry *other = known.find(news.name)) {
        news.knownKey = other->peer.key;
        news.knownRole = other->peer.role;
    }
    return news;
}

std::optional<channel::PublicKey> keyIn(const QJsonObject &object, const char *field)
{
    const auto key = keys::publicKeyFromText(object[QLatin1String(field)].toString().toStdString());
    return key ? std::optional(*key) : std::nullopt;
}

} // namespace

std::optional<PairingNews> newsOf(const channel::PairingEvent &event, const keys::PeersFile &known, const std::string &callIt)
{
    using Out = std::optional<PairingNews>;
    const auto plain = [](State state, const char *reason) {
        PairingNews news;
        news.state = state;
        news.reason = reason;
        return Out(news);
    };
    return std::visit(Overloaded{
                          [&](const channel::PairingPeerSeen &e) { return Out(seen(e.peer, known, callIt)); },
                          [&](const channel::PairingPeerConfirmed &) { return plain(State::Confirmed, ""); },
                          [&](const channel::PairingPeerGone &e) { return plain(State::Gone, words(e.reason)); },
                          [&](const channel::PairingOtherTried &e) { return Out(about(State::Other, e.peer)); },
                          [&](const channel::PairingPassphraseDiffers &) { return plain(State::Differs, ""); },
                          [&](const channel::Paired &) { return Out(); },
                          [&](const channel::PairingOver &e) { return plain(State::Over, words(e.reason)); },
                      },
                      event);
}

std::string PairingNews::toJson() const
{
    JsonWriter json;
    json.beginObject().field("event", "pairing");
    for (const StateWord &word : kWords) {
        if (word.state == state)
            json.field("state", word.word);
    }
    if (!name.empty())
        json.field("name", name).field("role", keys::peerRoleText(role));
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

std::optional<PairingNews> PairingNews::fromJson(const QByteArray &line)
{
    const QJsonObject object = QJsonDocument::fromJson(line).object();
    const std::string word = object[QLatin1String("state")].toString().toStdString();
    for (const StateWord &candidate : kWords) {
        if (candidate.word != word)
            continue;
        PairingNews news;
        news.state = candidate.state;
        news.name = object[QLatin1String("name")].toString().toStdString();
        news.role = keys::peerRoleFromText(object[QLatin1String("role")].toString().toStdString()).value_or(channel::PeerRole::Pilot);
        news.key = keyIn(object, "public").value_or(channel::PublicKey{});
        news.knownKey = keyIn(object, "known_public");
        news.knownRole = keys::peerRoleFromText(object[QLatin1String("known_role")].toString().toStdString());
        news.reason = object[QLatin1String("reason")].toString().toStdString();
        news.seconds = object[QLatin1String("seconds")].toInt();
        return news;
    }
    return std::nullopt;
}

} // namespace skyseal::app
