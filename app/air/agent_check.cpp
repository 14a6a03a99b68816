#include "app/air/agent_check.h"

#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/x25519.h"
#include "core/engine/agent/vehicle_key.h"
#include "core/engine/common/secret_files.h"
#include "core/keys/file_io.h"
#include "core/keys/secret_file.h"
#include "core/link/address_text.h"

#include <QtCore/QFileInfo>
#include <QtNetwork/QHostInfo>
#include <QtNetwork/QTcpServer>
#include <QtNetwork/QUdpSocket>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace skyseal::app {

namespace {

using Problems = std::vector<std::string>;

void checkDevice(const link::LinkUrl &url, Problems &problems)
{
    const int device = ::open(url.path().c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (device >= 0) {
        if (!::isatty(device))
            problems.push_back(url.path() + " is not a serial port");
        ::close(device);
    } else if (errno == EACCES) {
        problems.push_back(url.path() + ": this user has no permission to open it; add the user to the group dialout");
    } else {
        problems.push_back(url.path() + ": " + std::strerror(errno));
    }
}

/// A port that this machine listens on.
void checkPort(const link::LinkUrl &url, Problems &problems)
{
    const auto address = link::parseHost(url.host(), url.port());
    const QHostAddress host = address ? link::toQt(*address) : QHostAddress::LocalHost;
    QUdpSocket datagrams;
    QTcpServer streams;
    const bool free = url.traits().isStream ? streams.listen(host, url.port()) : datagrams.bind(host, url.port());
    if (!free)
        problems.push_back(url.toText() + ": "
                           + (url.traits().isStream ? streams.errorString() : datagrams.errorString()).toStdString()
                           + "; another program, such as a running agent, may use the port");
}

void checkHost(const link::LinkUrl &url, Problems &problems)
{
    if (!link::parseHost(url.host(), 0) && QHostInfo::fromName(QString::fromStdString(url.host())).addresses().isEmpty())
        problems.push_back(url.toText() + ": the host " + url.host()
                           + " is not known; use its address, or add it to /etc/hosts");
}

void checkLink(const link::LinkUrl &url, Problems &problems)
{
    switch (url.type().target) {
    case link::LinkTarget::DeviceBaud: return checkDevice(url, problems);
    case link::LinkTarget::HostPort: return url.isListening() ? checkPort(url, problems) : checkHost(url, problems);
    case link::LinkTarget::File: return;
    }
}

/// The known stations. A start without a list creates it, and a first station is paired with the agent that runs, so that a
/// missing or empty list is no problem.
Result<std::vector<channel::Peer>, InputError> readStations(const engine::KeyPaths &paths)
{
    if (keys::fileExists(paths.peers))
        return engine::readSecretFiles(paths).map([](const auto &secrets) { return secrets->peers; });
    return keys::loadIdentity(paths.identity, paths.askPassphrase).map([](const auto &) {
        return std::vector<channel::Peer>();
    });
}

void checkKeys(const engine::KeyPaths &paths, Problems &problems)
{
    const auto stations = readStations(paths);
    if (!stations) {
        problems.push_back(stations.error().text());
        return;
    }
    const auto isPilot = [](const channel::Peer &peer) { return peer.role == channel::PeerRole::Pilot; };
    if (stations->empty())
        remark(paths.peers + (keys::fileExists(paths.peers) ? ": " : ": the start creates it; ")
               + "no station is known yet, start the agent and pair one with skyseal-air --pair --identity " + paths.identity);
    else if (std::none_of(stations->begin(), stations->end(), isPilot))
        problems.push_back(paths.peers + ": no station is a pilot, so none can command the vehicle");
    for (const std::string &file : {paths.identity, paths.peers}) {
        const QString folder = QFileInfo(QString::fromStdString(file)).absolutePath();
        if (::access(folder.toLocal8Bit().constData(), W_OK) != 0)
            problems.push_back(folder.toStdString()
                               + " is not writable, but holds the handshake counters and the list of peers");
    }
}

void checkSigning(const SigningSetup &signing, Problems &problems)
{
    if (signing.keyFile.empty())
        return;
    if (!QFileInfo::exists(QString::fromStdString(signing.keyFile))) {
        problems.push_back(signing.keyFile
                           + " does not exist: skyseal-air --signing setup creates the key and sends it to the vehicle");
        return;
    }
    if (const auto key = engine::readVehicleKey(signing.keyFile); !key)
        problems.push_back(key.error().text());
    const QString folder = QFileInfo(QString::fromStdString(signing.keyFile)).absolutePath();
    if (::access(folder.toLocal8Bit().constData(), W_OK) != 0)
        problems.push_back(folder.toStdString() + " is not writable, but holds the timestamp of the signatures");
}

} // namespace

int checkSetup(const AgentSetup &setup)
{
    Problems problems;
    if (!crypto::initCrypto())
        problems.emplace_back("the system provides no randomness");
    else
        checkKeys(setup.keys, problems);
    checkSigning(setup.signing, problems);
    checkLink(setup.config.vehicle, problems);
    for (const engine::GroundLink &ground : setup.config.grounds)
        checkLink(ground.url, problems);
    std::sort(problems.begin(), problems.end());
    problems.erase(std::unique(problems.begin(), problems.end()), problems.end());
    for (const std::string &problem : problems)
        printLine(problem);
    if (problems.empty())
        printLine("the configuration is valid");
    return problems.empty() ? kDone : kNotReached;
}

} // namespace skyseal::app
