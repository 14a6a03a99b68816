// Debian's broker mosquitto with the configuration of packaging/fleet, on a port of its own, and certificates for it.
#pragma once

#include "tests/support/program.h"
#include "tests/support/run_program.h"

#include <QtCore/QFile>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtNetwork/QSslCertificate>
#include <QtNetwork/QSslConfiguration>
#include <QtNetwork/QSslKey>
#include <QtNetwork/QTcpSocket>

#include <memory>

namespace skyseal::test {

inline QString findMosquitto()
{
    return QStandardPaths::findExecutable(QStringLiteral("mosquitto"),
                                          {QStringLiteral("/usr/sbin"), QStringLiteral("/usr/bin")});
}

/// An authority that signs certificates; files NAME.crt and NAME.key in its folder.
class Authority
{
public:
    Authority() { openssl({"req", "-x509", "-days", "2", "-subj", "/CN=fleet", "-keyout", "ca.key", "-out", "ca.crt"}, true); }

    QString path(const QString &name) const { return m_folder.filePath(name); }
    /// With a slash at its end.
    QString folder() const { return m_folder.path() + QLatin1Char('/'); }

    /// `name`: the common name. Valid for the host 127.0.0.1.
    void certify(const char *name)
    {
        const QByteArray key = QByteArray(name) + ".key", request = QByteArray(name) + ".csr", out = QByteArray(name) + ".crt";
        QFile extension(path(QStringLiteral("san")));
        if (!extension.open(QIODevice::WriteOnly) || extension.write("subjectAltName=IP:127.0.0.1\n") < 0)
            qFatal("no folder");
        extension.close();
        openssl({"req", "-subj", QByteArray("/CN=") + name, "-keyout", key, "-out", request}, true);
        openssl({"x509", "-req", "-days", "2", "-in", request, "-CA", "ca.crt", "-CAkey", "ca.key", "-CAcreateserial",
                 "-extfile", "san", "-out", out});
        QFile::setPermissions(path(QString::fromLatin1(key)), QFile::ReadOwner | QFile::WriteOwner);
    }

    void openssl(const QByteArrayList &arguments, bool newKey = false) const
    {
        static const QByteArrayList kFiles{"-in", "-out", "-keyout", "-CA", "-CAkey", "-extfile"};
        QStringList all;
        for (qsizetype i = 0; i < arguments.size(); ++i) {
            const QString word = QString::fromLatin1(arguments[i]);
            all << (i > 0 && kFiles.contains(arguments[i - 1]) ? path(word) : word);
        }
        if (newKey)
            all << QStringLiteral("-newkey") << QStringLiteral("ec") << QStringLiteral("-pkeyopt")
                << QStringLiteral("ec_paramgen_curve:P-256") << QStringLiteral("-nodes");
        const RunResult result = runToItsEnd(QStringLiteral("openssl"), all);
        if (result.status != 0)
            qFatal("openssl %s: %s", qPrintable(all.join(QLatin1Char(' '))), result.err.constData());
    }

    /// The TLS settings of a client with this certificate.
    QSslConfiguration clientSettings(const char *name) const
    {
        QFile key(path(QLatin1String(name) + QStringLiteral(".key")));
        if (!key.open(QIODevice::ReadOnly))
            qFatal("no key");
        QSslConfiguration out = QSslConfiguration::defaultConfiguration();
        out.setCaCertificates(QSslCertificate::fromPath(path(QStringLiteral("ca.crt"))));
        out.setLocalCertificate(QSslCertificate::fromPath(path(QLatin1String(name) + QStringLiteral(".crt"))).value(0));
        out.setPrivateKey(QSslKey(&key, QSsl::Ec));
        return out;
    }

private:
    QTemporaryDir m_folder;
};

class Mosquitto
{
public:
    /// `authority` has certified "broker". `more`: further lines of the configuration.
    explicit Mosquitto(const Authority &authority, const QByteArray &more = {})
    {
        QFile shipped(QStringLiteral(SKYSEAL_SOURCE_DIR "/packaging/fleet/mosquitto.conf")), own(configFile());
        if (!shipped.open(QIODevice::ReadOnly) || !own.open(QIODevice::WriteOnly))
            qFatal("no configuration of mosquitto");
        const auto file = [&authority](const char *name) { return authority.path(QLatin1String(name)).toLocal8Bit(); };
        QByteArray text = shipped.readAll();
        text.replace("listener 8883", "listener " + QByteArray::number(port) + " 127.0.0.1");
        text.replace("/etc/mosquitto/certs/fleet-ca.crt", file("ca.crt"));
        text.replace("/etc/mosquitto/certs/broker.crt", file("broker.crt"));
        text.replace("/etc/mosquitto/certs/broker.key", file("broker.key"));
        text.replace("/etc/mosquitto/skyseal.acl", SKYSEAL_SOURCE_DIR "/packaging/fleet/skyseal.acl");
        own.write(text + "\nuser root\n" + more); // started by root, it would become a user who cannot read the folder
        own.close();
        start();
    }

    bool start()
    {
        m_program = std::make_unique<Program>(findMosquitto(), QStringList{QStringLiteral("-c"), configFile()});
        return eventually([this] {
            QTcpSocket probe;
            probe.connectToHost(QHostAddress::LocalHost, port);
            return probe.waitForConnected(kDeadlineMs);
        });
    }
    int stop() { return m_program->terminate(); }
    /// Returns false if it did not run.
    bool kill()
    {
        const bool ran = m_program->running();
        m_program->kill();
        return ran;
    }
    qint64 pid() const { return m_program->pid(); }

    const quint16 port = freeTcpPort();

private:
    QString configFile() const { return m_folder.filePath(QStringLiteral("mosquitto.conf")); }

    QTemporaryDir m_folder;
    std::unique_ptr<Program> m_program;
};

} // namespace skyseal::test
