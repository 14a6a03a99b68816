#include "app/skyseal/keyring.h"

#include "core/crypto/passphrase.h"
#include "core/crypto/x25519.h"
#include "core/base/hex.h"
#include "core/crypto/system_random.h"
#include "core/engine/text/qt_text.h"
#include "core/keys/file_io.h"
#include "core/keys/peers_file.h"
#include "core/keys/public_key_text.h"
#include "core/keys/secret_file.h"

#include <QtCore/QFile>

#include <algorithm>

namespace skyseal::app {

using keys::PeerEntry;
using keys::PeersFile;

namespace {

QString seenKey(const channel::PublicKey &key)
{
    return QStringLiteral("seen/") + QString::fromStdString(toHex(key));
}

/// The properties set by the user; the rest of the entry is kept.
void decide(PeerEntry &entry, const ui::KnownPeer &peer)
{
    entry.peer.name = peer.name.toStdString();
    entry.peer.role = peer.role;
    entry.peer.systemIds = peer.systems;
    entry.peer.key = peer.key;
}

/// Thread-safe.
Result<void, InputError> reseal(const std::string &file, const std::optional<crypto::Passphrase> &present,
                                const std::optional<crypto::Passphrase> &next)
{
    const auto pair = keys::loadIdentity(
        file, [&](const std::string &name, int attempt) -> Result<crypto::Passphrase, InputError> {
            if (attempt > 0 || !present)
                return tl::unexpected(
                    InputError{sentence("Reason", "the passphrase does not open it, or the file was changed"), name});
            return present->clone();
        });
    if (!pair)
        return tl::unexpected(pair.error());
    crypto::SystemRandom random;
    return keys::rewriteIdentity(file, *pair, random, {next ? &*next : nullptr});
}

} // namespace

Keyring::Keyring(QSettings &store, PassphraseMemory &memory, QObject *parent)
    : KeyringInterface(parent), m_store(store), m_memory(memory)
{
    connect(&memory, &PassphraseMemory::done, this, &Keyring::changed);
}

void Keyring::use(const engine::KeyPaths &paths)
{
    m_paths = paths;
    m_problem.clear();
    m_sessions.clear();
    Q_EMIT changed();
}

void Keyring::setProblem(const QString &problem)
{
    m_problem = problem;
    Q_EMIT changed();
}

void Keyring::handleEvent(const engine::Event &event)
{
    if (const auto *up = std::get_if<channel::SessionUp>(&event)) {
        m_sessions[up->session] = up->peer;
        m_store.setValue(seenKey(up->peer), QDateTime::currentDateTime());
    } else if (const auto *down = std::get_if<channel::SessionDown>(&event)) {
        const auto found = m_sessions.find(down->session);
        if (found == m_sessions.end())
            return;
        m_store.setValue(seenKey(found->second), QDateTime::currentDateTime());
        m_sessions.erase(found);
    } else {
        return;
    }
    Q_EMIT changed();
}

ui::OwnKey Keyring::ownKey() const
{
    ui::OwnKey out;
    out.file = QString::fromStdString(m_paths.identity);
    out.problem = m_problem;
    if (m_paths.identity.empty() || !m_problem.isEmpty())
        return out;
    const auto facts = keys::readIdentityFacts(m_paths.identity);
    if (facts) {
        out.publicKey = facts->publicKey;
        out.sealed = facts->sealed;
        out.remembered = facts->sealed && m_memory.remembers(m_paths.identity);
        out.keyringProblem = m_memory.problem();
    } else {
        out.problem = engine::reasonText(facts.error().reason());
    }
    return out;
}

ui::PeerList Keyring::peerList() const
{
    ui::PeerList out;
    out.file = QString::fromStdString(m_paths.peers);
    if (m_paths.peers.empty())
        return out;
    const auto file = PeersFile::load(m_paths.peers);
    if (!file) {
        out.problem = engine::reasonText(file.error().reason());
        return out;
    }
    for (const PeerEntry &entry : file->entries()) {
        ui::KnownPeer peer;
        peer.name = QString::fromStdString(entry.peer.name);
        peer.role = entry.peer.role;
        peer.systems = entry.peer.systemIds;
        peer.key = entry.peer.key;
        peer.hasPresharedKey = !entry.presharedKeyFile.empty();
        peer.connected = std::ranges::any_of(m_sessions, [&](const auto &session) { return session.second == entry.peer.key; });
        peer.lastSeen = m_store.value(seenKey(entry.peer.key)).toDateTime();
        out.peers.push_back(std::move(peer));
    }
    return out;
}

Result<void, InputError> Keyring::note(Result<void, InputError> result)
{
    if (result) {
        Q_EMIT edited();
        Q_EMIT changed();
    }
    return result;
}

Result<void, InputError> Keyring::addPeer(const ui::KnownPeer &peer)
{
    return note(keys::editPeers(m_paths.peers, [&](PeersFile &file) {
        PeerEntry entry;
        decide(entry, peer);
        return file.add(std::move(entry));
    }));
}

Result<void, InputError> Keyring::changePeer(const QString &name, const ui::KnownPeer &changed)
{
    const std::string old = name.toStdString();
    return note(keys::editPeers(m_paths.peers, [&](PeersFile &file) -> Result<void, InputError> {
        const PeerEntry *known = file.find(old);
        if (!known)
            return tl::unexpected(InputError{sentence("Reason", "there is no peer named \"%1\" any more")(old), {}});
        PeerEntry entry = *known;
        decide(entry, changed);
        if (auto renamed = file.rename(old, entry.peer.name); !renamed)
            return renamed;
        return file.replace(std::move(entry));
    }));
}

Result<void, InputError> Keyring::removePeer(const QString &name)
{
    return note(keys::editPeers(m_paths.peers, [&](PeersFile &file) -> Result<void, InputError> {
        if (!file.remove(name.toStdString()))
            return tl::unexpected(
                InputError{sentence("Reason", "there is no peer named \"%1\" any more")(name.toStdString()), {}});
        return {};
    }));
}

Result<QString, InputError> Keyring::readKeyText(const QString &name) const
{
    constexpr qint64 kLongest = 1024;
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(
            InputError{sentence("Reason", "cannot be read: %1")(file.errorString().toStdString()), name.toStdString()});
    const QByteArray content = file.read(kLongest);
    const auto key = keys::publicKeyFromText(content.toStdString());
    if (!key) // without its text: the file may be a private key picked by mistake
        return tl::unexpected(InputError{sentence("Reason", "holds no public key of Skyseal"), name.toStdString()});
    return QString::fromStdString(keys::publicKeyText(*key));
}

Result<void, InputError> Keyring::exportPublicKey(const QString &file) const
{
    const auto facts = keys::readIdentityFacts(m_paths.identity);
    if (!facts)
        return tl::unexpected(facts.error());
    return keys::replaceFile(file.toStdString(), asBytes(keys::publicKeyText(facts->publicKey) + "\n"));
}

void Keyring::changePassphrase(std::optional<crypto::Passphrase> present, std::optional<crypto::Passphrase> next, bool remember)
{
    struct Change
    {
        std::string file;
        std::optional<crypto::Passphrase> present, next;
        bool remember;
    };
    const auto change = std::make_shared<const Change>(Change{m_paths.identity, std::move(present), std::move(next), remember});
    m_worker.start([this, change] {
        const auto changed = reseal(change->file, change->present, change->next);
        const QString problem = changed ? QString() : engine::reasonText(changed.error().reason());
        const auto finish = [this, change, problem] {
            if (problem.isEmpty() && change->next && change->remember)
                m_memory.remember(change->file, *change->next);
            else if (problem.isEmpty() && m_memory.remembers(change->file))
                m_memory.forget(change->file);
            Q_EMIT this->changed();
            Q_EMIT passphraseDone(problem);
        };
        QMetaObject::invokeMethod(this, finish, Qt::QueuedConnection);
    });
}

} // namespace skyseal::app

#include "moc_keyring.cpp"
