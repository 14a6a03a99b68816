#include "core/link/port_owner.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

#include <ifaddrs.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace skyseal::link {

namespace fs = std::filesystem;

namespace {

/// A line of /proc/net/tcp or udp.
struct SocketLine
{
    std::string localAddress, remoteAddress; ///< hexadecimal, as the kernel writes them
    unsigned long localPort = 0, remotePort = 0;
    std::string state, inode;
};

std::vector<SocketLine> socketLines(PortKind kind)
{
    std::vector<SocketLine> out;
    const std::string base = kind == PortKind::Udp ? "/proc/net/udp" : "/proc/net/tcp";
    for (const std::string &path : {base, base + "6"}) {
        std::ifstream file(path);
        std::string line;
        std::getline(file, line); // the headings
        while (std::getline(file, line)) {
            std::istringstream fields(line);
            std::string slot, local, remote, queues, timer, retransmits, user, timeout;
            SocketLine one;
            fields >> slot >> local >> remote >> one.state >> queues >> timer >> retransmits >> user >> timeout >> one.inode;
            const std::size_t localColon = local.find(':'), remoteColon = remote.find(':');
            if (localColon == local.npos || remoteColon == remote.npos)
                continue;
            one.localAddress = local.substr(0, localColon);
            one.remoteAddress = remote.substr(0, remoteColon);
            one.localPort = std::strtoul(local.c_str() + localColon + 1, nullptr, 16);
            one.remotePort = std::strtoul(remote.c_str() + remoteColon + 1, nullptr, 16);
            out.push_back(std::move(one));
        }
    }
    return out;
}

/// The program that holds one of these sockets.
std::optional<PortOwner> holderOf(const std::vector<SocketLine> &lines)
{
    if (lines.empty())
        return std::nullopt;
    std::vector<std::string> sockets; // targets of the links in /proc/PID/fd
    sockets.reserve(lines.size());
    for (const SocketLine &line : lines)
        sockets.push_back("socket:[" + line.inode + "]");
    // Processes may end meanwhile, and those of other users are not readable: skip failures.
    std::error_code error;
    for (fs::directory_iterator process("/proc", error), end; !error && process != end; process.increment(error)) {
        const std::string pid = process->path().filename();
        if (pid.find_first_not_of("0123456789") != pid.npos)
            continue;
        std::error_code denied;
        for (fs::directory_iterator file(process->path() / "fd", denied); !denied && file != end; file.increment(denied)) {
            std::error_code gone;
            const std::string target = fs::read_symlink(file->path(), gone);
            if (gone || std::find(sockets.begin(), sockets.end(), target) == sockets.end())
                continue;
            std::string name;
            std::ifstream comm(process->path() / "comm");
            std::getline(comm, name);
            return name.empty() ? std::nullopt : std::optional(PortOwner{name, std::strtoll(pid.c_str(), nullptr, 10)});
        }
    }
    return std::nullopt;
}

/// As the kernel writes the first bytes of an IPv4 address within IPv6, ::ffff:a.b.c.d.
constexpr std::string_view kKernelMapped = "0000000000000000FFFF0000";

/// The 16 bytes of an address as the kernel writes them: four words in the byte order of the machine.
std::string kernelText(const Address &address)
{
    std::string out;
    for (std::size_t at = 0; at < address.ip.size(); at += sizeof(std::uint32_t)) {
        std::uint32_t word = 0;
        std::memcpy(&word, &address.ip[at], sizeof word);
        char text[9];
        std::snprintf(text, sizeof text, "%08X", word);
        out += text;
    }
    return out;
}

/// The IPv4 addresses of this machine as the kernel writes them, also within IPv6.
bool isOwnAddress(const std::string &hexadecimal)
{
    static constexpr const char *kLoopback = "00000000000000000000000001000000";
    if (hexadecimal == kLoopback)
        return true;
    ifaddrs *first = nullptr;
    if (::getifaddrs(&first) != 0)
        return false;
    bool isOwn = false;
    for (const ifaddrs *one = first; one; one = one->ifa_next) {
        if (!one->ifa_addr || one->ifa_addr->sa_family != AF_INET)
            continue;
        sockaddr_in address{};
        std::memcpy(&address, one->ifa_addr, sizeof address);
        char text[9];
        std::snprintf(text, sizeof text, "%08X", address.sin_addr.s_addr);
        isOwn = isOwn || hexadecimal == text || hexadecimal == std::string(kKernelMapped) + text;
    }
    ::freeifaddrs(first);
    return isOwn;
}

} // namespace

std::optional<PortOwner> portOwner(PortKind kind, std::uint16_t port)
{
    static constexpr const char *kTcpListen = "0A"; // state TCP_LISTEN
    std::vector<SocketLine> lines = socketLines(kind);
    std::erase_if(lines, [&](const SocketLine &line) {
        return line.localPort != port || (kind == PortKind::Tcp && line.state != kTcpListen);
    });
    return holderOf(lines);
}

std::optional<PortOwner> portCaller(PortKind kind, std::uint16_t port)
{
    static constexpr const char *kEstablished = "01"; // also of a connected UDP socket
    std::vector<SocketLine> lines = socketLines(kind);
    std::erase_if(lines, [&](const SocketLine &line) {
        return line.remotePort != port || line.state != kEstablished || !isOwnAddress(line.remoteAddress);
    });
    return holderOf(lines);
}

std::optional<PortOwner> datagramSender(const Address &source)
{
    const std::string v6 = kernelText(source), v4 = v6.substr(kKernelMapped.size());
    const bool isV4 = v6.starts_with(kKernelMapped);
    if (!isOwnAddress(isV4 ? v4 : v6))
        return std::nullopt;
    std::vector<SocketLine> lines = socketLines(PortKind::Udp);
    std::erase_if(lines, [&](const SocketLine &line) {
        const bool isAny = line.localAddress.find_first_not_of('0') == std::string::npos;
        return line.localPort != source.port || !(isAny || line.localAddress == v6 || (isV4 && line.localAddress == v4));
    });
    return holderOf(lines);
}

std::string portOwnerText(PortKind kind, std::uint16_t port)
{
    const auto owner = portOwner(kind, port);
    return owner ? owner->name + " (process " + std::to_string(owner->process) + ")" : std::string();
}

} // namespace skyseal::link
