#include "core/link/link_type.h"

#if defined(SKYSEAL_HAVE_SERIAL)
#include "core/link/serial_link.h"
#endif
#include "core/link/tcp_link.h"
#include "core/link/tcp_server_link.h"
#include "core/link/tlog_link.h"
#include "core/link/udp_link.h"

#include <QtCore/QtGlobal>

#include <algorithm>
#include <vector>

namespace skyseal::link {

namespace {

template<typename T>
std::unique_ptr<Link> make(const LinkUrl &url, LinkId id, LinkListener &listener, const LinkOptions &options)
{
    return std::make_unique<T>(url, id, listener, options);
}

#if defined(SKYSEAL_HAVE_SERIAL)
constexpr auto makeSerial = make<SerialLink>;
#else
constexpr decltype(LinkType::make) makeSerial = nullptr;
#endif

constexpr std::uint32_t kRadioBaud = 57600; // factory setting of SiK telemetry radios

constexpr LinkType kTypes[] = {
    {"udpin",
     LinkTarget::HostPort,
     {.isListening = true},
     QT_TRANSLATE_NOOP("skyseal::link::LinkType", "UDP, listen for vehicles"),
     QT_TRANSLATE_NOOP("skyseal::link::LinkType", "Receives datagrams on a local port; each sender is a peer."),
     make<UdpLink>},
    {"udpout",
     LinkTarget::HostPort,
     {.hasOneRemote = true},
     QT_TRANSLATE_NOOP("skyseal::link::LinkType", "UDP, send to an address"),
     QT_TRANSLATE_NOOP("skyseal::link::LinkType", "Sends datagrams to one host and receives its answers."),
     make<UdpLink>},
    {"tcp",
     LinkTarget::HostPort,
     {.isStream = true, .hasOneRemote = true},
     QT_TRANSLATE_NOOP("skyseal::link::LinkType", "TCP, connect to an address"),
     QT_TRANSLATE_NOOP("skyseal::link::LinkType", "Connects to one server and reconnects when the connection is lost."),
     make<TcpLink>},
    {"tcpin",
     LinkTarget::HostPort,
     {.isStream = true, .isListening = true},
     QT_TRANSLATE_NOOP("skyseal::link::LinkType", "TCP, listen for connections"),
     QT_TRANSLATE_NOOP("skyseal::link::LinkType", "Accepts connections on a local port; each client is a peer."),
     make<TcpServerLink>},
    {"serial",
     LinkTarget::DeviceBaud,
     {.isStream = true, .hasOneRemote = true},
     QT_TRANSLATE_NOOP("skyseal::link::LinkType", "Serial radio"),
     QT_TRANSLATE_NOOP("skyseal::link::LinkType",
                       "Opens a serial device: 8 data bits, no parity, 1 stop bit, no flow control."),
     makeSerial,
     kRadioBaud},
    {"tlog",
     LinkTarget::File,
     {.isRecording = true},
     QT_TRANSLATE_NOOP("skyseal::link::LinkType", "Recorded log"),
     QT_TRANSLATE_NOOP("skyseal::link::LinkType",
                       "Replays a telemetry log at the recorded pace, with pauses of at most five seconds; nothing is sent."),
     make<TlogLink>},
};

const char *formOf(LinkTarget target)
{
    switch (target) {
    case LinkTarget::HostPort: return ":HOST:PORT";
    case LinkTarget::DeviceBaud: return ":/dev/NAME:BAUD";
    case LinkTarget::File: return ":FILE";
    }
    return "";
}

char lowered(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

std::string LinkType::syntax() const
{
    return std::string(scheme) + formOf(target);
}

std::span<const LinkType> linkTypes()
{
    return kTypes;
}

const LinkType *findLinkType(std::string_view scheme, std::span<const LinkType> types)
{
    const auto found = std::find_if(types.begin(), types.end(), [scheme](const LinkType &type) {
        const std::string_view known = type.scheme;
        return std::equal(scheme.begin(), scheme.end(), known.begin(), known.end(),
                          [](char a, char b) { return lowered(a) == b; });
    });
    return found == types.end() ? nullptr : &*found;
}

std::string linkForms(bool (*accepted)(const LinkTraits &))
{
    std::vector<std::string> forms;
    for (const LinkType &type : linkTypes()) {
        if (!accepted || accepted(type.traits))
            forms.push_back(type.syntax());
    }
    std::string out;
    for (std::size_t i = 0; i < forms.size(); ++i)
        out.append(i == 0 ? "" : i + 1 == forms.size() ? " or " : ", ").append(forms[i]);
    return out;
}

} // namespace skyseal::link
