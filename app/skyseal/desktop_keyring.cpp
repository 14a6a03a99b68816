// The desktop's keyring by QtKeychain: the Secret Service of GNOME and others, or KWallet.
#include "app/skyseal/passphrase_memory.h"

#include "core/base/secret_bytes.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QPointer>
#include <QtDBus/QDBusConnection>
#include <QtDBus/QDBusConnectionInterface>

#include <qt6keychain/keychain.h>

#include <algorithm>
#include <utility>

namespace skyseal::app {

namespace {

const QString kService = QStringLiteral("skyseal");
const QString kNoted = QStringLiteral("passphrase/remembered");

QString entryOf(const std::string &file)
{
    return QStringLiteral("passphrase of %1").arg(QString::fromStdString(file));
}

/// Wipes the bytes in place, which the job shares: writing through data() would detach and wipe a copy.
void wipe(const QByteArray &shared)
{
    wipeSecret(const_cast<char *>(shared.constData()), static_cast<std::size_t>(shared.size()));
}

std::optional<crypto::Passphrase> foundBy(const QKeychain::ReadPasswordJob &job)
{
    if (job.error() != QKeychain::NoError)
        return std::nullopt;
    const QByteArray found = job.binaryData();
    auto out = crypto::Passphrase::fromBytes(
        {reinterpret_cast<const std::uint8_t *>(found.constData()), static_cast<std::size_t>(found.size())});
    wipe(found);
    return out;
}

class DesktopKeyring : public PassphraseMemory
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::app::DesktopKeyring)

public:
    explicit DesktopKeyring(QSettings &store) : m_store(store) {}

    QString problem() const override
    {
        if (!m_problem)
            m_problem = look();
        return *m_problem;
    }

    bool remembers(const std::string &file) const override { return noted().contains(QString::fromStdString(file)); }

    void recall(const std::string &file, QObject *context, Recalled recalled) override
    {
        auto *job = new QKeychain::ReadPasswordJob(kService, this);
        job->setKey(entryOf(file));
        // Also without its context, so that what was found is wiped.
        const auto finish = [this, job, file, asked = QPointer(context), recalled = std::move(recalled)] {
            auto found = foundBy(*job);
            if (job->error() == QKeychain::EntryNotFound)
                note(file, false);
            if (asked)
                recalled(std::move(found));
        };
        connect(job, &QKeychain::Job::finished, this, finish);
        job->start();
    }

    void remember(const std::string &file, const crypto::Passphrase &passphrase) override
    {
        const ByteView view = passphrase.view();
        const QByteArray bytes(reinterpret_cast<const char *>(view.data()), static_cast<qsizetype>(view.size()));
        auto *job = new QKeychain::WritePasswordJob(kService, this);
        job->setKey(entryOf(file));
        job->setBinaryData(bytes);
        connect(job, &QKeychain::Job::finished, this, [bytes] { wipe(bytes); });
        run(job, file, true);
    }

    void forget(const std::string &file) override
    {
        auto *job = new QKeychain::DeletePasswordJob(kService, this);
        job->setKey(entryOf(file));
        run(job, file, false);
    }

private:
    /// Checked before anything is stored: QtKeychain can detect it only by opening the keyring, which may prompt the operator.
    static QString look()
    {
        const QDBusConnection bus = QDBusConnection::sessionBus();
        if (!bus.isConnected())
            return tr("there is no desktop session");
        const QStringList known = bus.interface()->registeredServiceNames().value()
            + bus.interface()->activatableServiceNames().value();
        const bool there = std::ranges::any_of(known, [](const QString &name) {
            return name == QLatin1String("org.freedesktop.secrets") || name.startsWith(QLatin1String("org.kde.kwalletd"));
        });
        return there ? QString() : tr("no keyring is running in this desktop session");
    }

    QStringList noted() const { return m_store.value(kNoted).toStringList(); }

    void note(const std::string &file, bool kept)
    {
        QStringList files = noted();
        files.removeAll(QString::fromStdString(file));
        if (kept)
            files.append(QString::fromStdString(file));
        m_store.setValue(kNoted, files);
    }

    void run(QKeychain::Job *job, const std::string &file, bool keeps)
    {
        connect(job, &QKeychain::Job::finished, this, [this, file, keeps](const QKeychain::Job *ended) {
            const bool gone = !keeps && ended->error() == QKeychain::EntryNotFound;
            if (ended->error() != QKeychain::NoError && !gone) {
                Q_EMIT failed(keeps ? tr("The keyring did not store the passphrase: %1").arg(ended->errorString())
                                    : tr("The keyring did not delete the passphrase: %1").arg(ended->errorString()));
                return;
            }
            note(file, keeps);
            Q_EMIT done();
        });
        job->start();
    }

    QSettings &m_store;
    mutable std::optional<QString> m_problem; ///< determined once
};

} // namespace

std::unique_ptr<PassphraseMemory> desktopMemory(QSettings &store)
{
    return std::make_unique<DesktopKeyring>(store);
}

} // namespace skyseal::app
