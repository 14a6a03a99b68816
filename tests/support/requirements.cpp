#include "tests/support/requirements.h"

#include "tests/support/node_mavlink.h"
#include "tests/support/run_program.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>

#include <algorithm>

#include <netdb.h>
#include <netinet/in.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

namespace skyseal::test {

namespace {

bool g_isSomethingMissing = false;

bool isNamedBy(const char *variable)
{
    return !qEnvironmentVariableIsEmpty(variable);
}

bool areInstalled(const char *programs)
{
    const QStringList ofTheSuperuser{QStringLiteral("/usr/sbin")}; // on the PATH of few others
    return std::ranges::all_of(words(programs), [&](const QString &program) {
        return !QStandardPaths::findExecutable(program).isEmpty()
            || !QStandardPaths::findExecutable(program, ofTheSuperuser).isEmpty();
    });
}

bool succeeds(const char *program, const QStringList &arguments)
{
    return runToItsEnd(QString::fromLatin1(program), arguments).status == 0;
}

bool canPerfSample()
{
    const QTemporaryDir folder;
    return succeeds("perf",
                    words("record -q -e cpu-clock:u -o") << folder.filePath(QStringLiteral("data")) << QStringLiteral("true"));
}

/// The test of constant time also needs Valgrind's header when it is compiled.
bool hasValgrind()
{
#if __has_include(<valgrind/memcheck.h>)
    return areInstalled("valgrind");
#else
    return false;
#endif
}

bool isSuperuser()
{
    return ::geteuid() == 0;
}

/// More than the keys of a program and of the tests take.
bool canLockMemory()
{
    constexpr std::size_t kSize = 1 << 20;
    void *const page = ::mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    const bool locked = page != MAP_FAILED && ::mlock(page, kSize) == 0;
    ::munmap(page, kSize);
    return locked;
}

bool hasIpv6()
{
    const int socket = ::socket(AF_INET6, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    sockaddr_in6 loopback{};
    loopback.sin6_family = AF_INET6;
    loopback.sin6_addr = in6addr_loopback;
    const bool bound = ::bind(socket, reinterpret_cast<const sockaddr *>(&loopback), sizeof loopback) == 0;
    ::close(socket);
    return bound;
}

bool knowsLocalhost()
{
    addrinfo *found = nullptr;
    const bool known = ::getaddrinfo("localhost", nullptr, nullptr, &found) == 0;
    if (found)
        ::freeaddrinfo(found);
    return known;
}

constexpr Requirement kRequirements[] = {
    // Implementations and data of others, which the packages of packaging/dependencies do not include.
    {"arducopter", false, [] { return isNamedBy("ARDUPILOT_SITL"); }, "ARDUPILOT_SITL names no ArduCopter SITL"},
    {"mavproxy", false, [] { return isNamedBy("SKYSEAL_MAVPROXY"); }, "SKYSEAL_MAVPROXY names no MAVProxy"},
    {"mavlink_router", false, [] { return isNamedBy("SKYSEAL_MAVLINK_ROUTERD"); },
     "SKYSEAL_MAVLINK_ROUTERD names no mavlink-routerd"},
    {"mavlink_facts", false, [] { return QFile::exists(mavlinkFactsFolder() + QStringLiteral("/ardupilotmega.json")); },
     "SKYSEAL_MAVLINK_FACTS names no folder with the full facts of MAVLink's messages"},
    {"published_vectors", false, [] { return !publishedVectorsFolder().isEmpty(); },
     "SKYSEAL_VECTORS names no folder with the published vector files"},
    {"proverif", false, [] { return isNamedBy("PROVERIF") || areInstalled("proverif"); },
     "proverif is not installed, and PROVERIF does not name it"},
    {"perf", false, canPerfSample, "perf is not installed (linux-perf) or may not sample (kernel.perf_event_paranoid)"},
    {"heaptrack", false, [] { return areInstalled("heaptrack heaptrack_print"); }, "heaptrack is not installed"},
    {"gnome_keyring", false, [] { return areInstalled("dbus-run-session gnome-keyring-daemon"); },
     "dbus-run-session or gnome-keyring-daemon is not installed (dbus-daemon, gnome-keyring)"},

    {"node_mavlink", true, [] { return !findNodeMavlink().isEmpty(); },
     "node is not installed, or SKYSEAL_NODE_MODULES names no folder with node-mavlink"},
    {"python_cryptography", true,
     [] { return succeeds(qPrintable(pythonProgram()), words("-c") << QStringLiteral("import cryptography")); },
     "Debian's python3, or the one that SKYSEAL_PYTHON names, lacks cryptography (python3-cryptography)"},
    {"mosquitto", true, [] { return areInstalled("mosquitto"); }, "mosquitto is not installed"},
    {"prometheus", true, [] { return areInstalled("prometheus"); }, "prometheus is not installed"},
    {"openssl", true, [] { return areInstalled("openssl"); }, "the program openssl is not installed"},
    {"x_server", true, [] { return areInstalled("Xvfb blackbox xdotool"); }, "Xvfb, blackbox or xdotool is not installed"},
    {"valgrind", true, hasValgrind, "Valgrind is not installed, or was not when this was built"},
    {"spin", true, [] { return areInstalled("spin"); }, "spin is not installed"},
    {"systemd_analyze", true, [] { return areInstalled("systemd-analyze"); }, "systemd-analyze is not installed (systemd)"},

    // The machine and the user. In many containers not even the superuser may mount.
    {"superuser", true, isSuperuser, "only the superuser can give files away and start programs of other users"},
    {"setpriv", true, [] { return !isSuperuser() || succeeds("setpriv", words("--inh-caps=-all --bounding-set=-all true")); },
     "the superuser cannot give up privileges (setpriv)"},
    {"mounts", false, [] { return succeeds("unshare", words("-m mount -t tmpfs none /tmp")); },
     "this user may not mount a disk in a namespace of its own"},
    {"locked_memory", true, canLockMemory, "this process may not lock a megabyte of memory (RLIMIT_MEMLOCK)"},
    {"ipv6", true, hasIpv6, "this machine has no IPv6"},
    {"localhost", true, knowsLocalhost, "this machine does not know localhost by name (/etc/hosts)"},
};

} // namespace

std::span<const Requirement> requirements()
{
    return kRequirements;
}

const char *lackOf(std::string_view requirement)
{
    const auto found = std::ranges::find(kRequirements, requirement,
                                         [](const Requirement &row) { return std::string_view(row.name); });
    if (found == std::end(kRequirements))
        qFatal("there is no requirement %.*s", static_cast<int>(requirement.size()), requirement.data());
    if (found->isMet())
        return nullptr;
    g_isSomethingMissing = true;
    return found->lack;
}

bool isSomethingMissing()
{
    return g_isSomethingMissing;
}

QString pythonProgram()
{
    return qEnvironmentVariable("SKYSEAL_PYTHON", QStringLiteral("/usr/bin/python3"));
}

QString mavlinkFactsFolder()
{
    return qEnvironmentVariable("SKYSEAL_MAVLINK_FACTS", QStringLiteral(SKYSEAL_SOURCE_DIR "/../shared/mavlink"));
}

QString publishedVectorsFolder()
{
    const QString beside = QStringLiteral(SKYSEAL_SOURCE_DIR "/../shared/vectors");
    return qEnvironmentVariable("SKYSEAL_VECTORS", QDir(beside).exists() ? beside : QString());
}

} // namespace skyseal::test
