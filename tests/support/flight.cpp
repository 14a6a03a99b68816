#include "tests/support/flight.h"

#include "core/crypto/suite.h"

#include <algorithm>

namespace skyseal::test {

namespace {

QString publicKeyOf(const QString &keyFile)
{
    Program show(QStringLiteral("skyseal-cli"),
                 {QStringLiteral("keys"), QStringLiteral("show"), keyFile, QStringLiteral("--json")});
    return show.waitFor(QStringLiteral("key"))[QLatin1String("public")].toString();
}

bool run(const QStringList &arguments)
{
    Program program(QStringLiteral("skyseal-cli"), arguments);
    const int status = program.waitForExit();
    if (status != 0)
        qWarning("skyseal-cli %s: exit status %d\n%s", qPrintable(arguments.join(QLatin1Char(' '))), status,
                 program.errors().constData());
    return status == 0;
}

QString loopback(const char *scheme, quint16 port)
{
    return QStringLiteral("%1:127.0.0.1:%2").arg(QLatin1String(scheme)).arg(port);
}

} // namespace

Flight::Flight()
{
    const auto make = [this](const char *name) {
        return run({QStringLiteral("keys"), QStringLiteral("new"), QStringLiteral("--out"), path(QLatin1String(name))});
    };
    const auto introduce = [this](const char *peers, const char *name, const char *key) {
        return run({QStringLiteral("keys"), QStringLiteral("peers"), QStringLiteral("add"), QStringLiteral("--peers"),
                    path(QLatin1String(peers)), QStringLiteral("--name"), QLatin1String(name),
                    publicKeyOf(path(QLatin1String(key)))});
    };
    m_ready = m_folder.isValid() && make("ground.key") && make("air.key") && introduce("ground.peers", "air-1", "air.key")
        && introduce("air.peers", "ground", "ground.key");
}

QStringList Flight::simArguments(const QStringList &more) const
{
    return QStringList{QStringLiteral("--link"), loopback("udpout", vehiclePort), QStringLiteral("--seed"), QStringLiteral("7")}
    + more;
}

QStringList Flight::airArguments(quint16 ground, const QStringList &more) const
{
    return QStringList{QStringLiteral("--vehicle"),        loopback("udpin", vehiclePort),
                       QStringLiteral("--ground"),         loopback("udpout", ground ? ground : groundPort),
                       QStringLiteral("--identity"),       path(QStringLiteral("air.key")),
                       QStringLiteral("--peers"),          path(QStringLiteral("air.peers")),
                       QStringLiteral("--allow-research"), QStringLiteral("--json")}
    + more;
}

QStringList Flight::monitorArguments(const QStringList &more) const
{
    return QStringList{QStringLiteral("monitor"),          QStringLiteral("--link"),   loopback("udpin", groundPort),
                       QStringLiteral("--secure"),         QStringLiteral("required"), QStringLiteral("--identity"),
                       path(QStringLiteral("ground.key")), QStringLiteral("--peers"),  path(QStringLiteral("ground.peers")),
                       QStringLiteral("--allow-research"), QStringLiteral("--json")}
    + more;
}

QString allSuites()
{
    std::vector<crypto::SuiteId> suites = crypto::sealedSuites();
    std::rotate(suites.begin(), suites.begin() + 1, suites.end());
    QStringList names;
    for (const crypto::SuiteId suite : suites)
        names << QString::fromStdString(std::string(crypto::suiteInfo(suite).name));
    return names.join(QLatin1Char(','));
}

} // namespace skyseal::test
