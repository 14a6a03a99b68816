#include "core/link/port_owner.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace skyseal::link {

namespace fs = std::filesystem;

/// Targets of the links in /proc/PID/fd that denote a socket bound to the port: "socket:[inode]".
static std::vector<std::string> socketsOf(PortKind kind, std::uint16_t port)
{
    static constexpr const char *kTcpListen = "0A"; // state TCP_LISTEN in /proc/net/tcp
    std::vector<std::string> out;
    const std::string base = kind == PortKind::Udp ? "/proc/net/udp" : "/proc/net/tcp";
    for (const std::string &path : {base, base + "6"}) {
        std::ifstream file(path);
        std::string line;
        std::getline(file, line); // the headings
        while (std::getline(file, line)) {
            std::istringstream fields(line);
            std::string slot, local, remote, state, queues, timer, retransmits, user, timeout, inode;
            fields >> slot >> local >> remote >> state >> queues >> timer >> retransmits >> user >> timeout >> inode;
            const std::size_t colon = local.find(':');
            if (colon == local.npos || (kind == PortKind::Tcp && state != kTcpListen))
                continue;
            if (std::strtoul(local.c_str() + colon + 1, nullptr, 16) == port)
                out.push_back("socket:[" + inode + "]");
        }
    }
    return out;
}

std::optional<PortOwner> portOwner(PortKind kind, std::uint16_t port)
{
    const std::vector<std::string> sockets = socketsOf(kind, port);
    if (sockets.empty())
        return std::nullopt;
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

std::string portOwnerText(PortKind kind, std::uint16_t port)
{
    const auto owner = portOwner(kind, port);
    return owner ? owner->name + " (process " + std::to_string(owner->process) + ")" : std::string();
}

} // namespace skyseal::link
