#include "app/air/agent_options.h"

#include "app/air/signing_command.h"
#include "app/common/own_ports.h"
#include "app/common/pairing_passphrase_input.h"
#include "app/common/pairing_prompt.h"
#include "app/common/passphrase_input.h"
#include "core/channel/suite_strength.h"

#include <algorithm>

namespace skyseal::app {

namespace {

bool listens(const engine::GroundLink &ground)
{
    return ground.url.traits().isDatagramServer();
}

/// The carrier `name` for a link; its default if the name is empty.
Carrier readCarrier(Options &options, const link::LinkUrl &ground, const std::string &name)
{
    const bool datagrams = !ground.traits().isStream;
    const std::string wanted = !name.empty() ? name : datagrams ? "datagram" : "serial";
    if (wanted == "tunnel" && ground.traits().isDatagramServer())
        options.fail("--carrier 'tunnel': behind a router the agent must send first, but " + ground.toText() + " only listens");
    if (wanted == "tunnel")
        return Carrier::Tunnel;
    if (wanted != "datagram" && wanted != "serial")
        options.fail("--carrier '" + wanted + "': datagram, serial or tunnel is expected");
    else if (wanted == "datagram" && !datagrams)
        options.fail("--carrier 'datagram': " + ground.toText() + " is a byte stream; use serial or tunnel");
    else if (wanted == "serial" && datagrams)
        options.fail("--carrier 'serial': " + ground.toText() + " carries datagrams; use datagram or tunnel");
    return wanted == "serial" ? Carrier::Serial : Carrier::Datagram;
}

/// Each --ground is a URL, followed by ",carrier=NAME" if the carrier differs from --carrier.
std::vector<engine::GroundLink> readGrounds(Options &options)
{
    static constexpr std::string_view kCarrier = ",carrier=";
    std::vector<engine::GroundLink> out;
    const std::vector<std::string> given = options.texts("ground");
    if (given.empty())
        options.required("ground");
    if (given.size() > engine::kMostGrounds)
        options.fail("--ground: at most " + std::to_string(engine::kMostGrounds) + " links are possible");
    for (const std::string &text : given) {
        const std::size_t urlEnd = text.find(kCarrier);
        const auto url = options.parsedUrl("ground", text.substr(0, urlEnd));
        if (!url)
            continue;
        const std::string carrier = urlEnd == text.npos ? options.text("carrier") : text.substr(urlEnd + kCarrier.size());
        if (std::ranges::any_of(out, [&](const engine::GroundLink &other) { return other.url == *url; }))
            options.fail("--ground '" + text + "': this link is given twice");
        out.push_back({*url, readCarrier(options, *url, carrier)});
    }
    return out;
}

channel::FreshnessLimits readFreshness(Options &options)
{
    using Limits = channel::FreshnessLimits;
    Limits out;
    out.overtaken = options.seconds("max-overtaken", seconds(Limits::kLeastOvertaken), seconds(Limits::kMostOvertaken));
    out.age.reset();
    if (options.text("max-age") != "off")
        out.age = options.seconds("max-age", seconds(Limits::kLeastAge), seconds(Limits::kMostAge));
    return out;
}

SigningSetup readSigning(Options &options)
{
    SigningSetup out{options.text("vehicle-signing"), options.has("accept-unsigned")};
    if (out.acceptUnsigned && out.keyFile.empty())
        options.fail("--accept-unsigned requires --vehicle-signing");
    if (options.has("allow-plain") && !out.keyFile.empty())
        options.fail("--allow-plain: not with --vehicle-signing, which would sign the commands of anyone");
    if (options.has("send-key-in-clear"))
        options.fail("--send-key-in-clear requires --signing setup");
    return out;
}

std::vector<OptionLink> linksOf(const link::LinkUrl &vehicle, const std::vector<engine::GroundLink> &grounds)
{
    std::vector<OptionLink> out{{"vehicle", vehicle}};
    for (const engine::GroundLink &ground : grounds)
        out.push_back({"ground", ground.url});
    return out;
}

bool isSecure(crypto::SuiteId suite)
{
    return !crypto::suiteInfo(suite).research && suite != crypto::SuiteId::None;
}

} // namespace

void declareAgent(Options &options)
{
    options.addLink("vehicle",
                    "Plain MAVLink link to the autopilot, e.g. serial:/dev/ttyAMA0:921600, udpin:14551 or "
                    "tcp:127.0.0.1:5760. A listening link without a host listens on 127.0.0.1: any program that reaches that "
                    "port can control the vehicle.");
    options.addLink(
        "ground",
        "Sealed link to a ground station; the agent announces itself there. May be given up to 8 times: for several "
        "stations, or for several modems to one, whose session uses the link on which the station was heard last. "
        "With ,carrier=NAME after the URL, the link uses that carrier instead of --carrier. On a udpin link the agent does "
        "not announce itself, and answers only known stations, which connect to it with a udpout link.",
        isLive);
    options.addValue(
        "carrier", "datagram|serial|tunnel",
        "Encapsulation of sealed records on the ground links: datagram, one record per datagram; serial, COBS frames on a "
        "byte stream that only the two ends share; tunnel, MAVLink TUNNEL messages through MAVLink routers and "
        "radios, on any link except udpin. Default: datagram or serial, depending on the link. The station detects the "
        "carrier.");
    options.addValue("identity", "FILE", "Private key of this agent (skyseal-cli keys new).");
    PassphraseInput::declare(options);
    options.addValue("peers", "FILE", "List of the ground stations that may connect; created if missing.");
    options.addValue("suites", "LIST", "Suites to offer, separated by commas, the preferred one first.", "all");
    options.addValue("weakest-suite", "NAME", "Use no suite that is weaker than this one.",
                     crypto::suiteInfo(crypto::weakestSealedSuite()).name.data());
    options.addResearchFlag("allow-research", "Also accept insecure research suites, for comparison.");
    options.addResearchFlag(
        "allow-plain",
        "Forward plain MAVLink while no session is up; anyone can read and forge it. For baseline measurements.");
    options.addResearchFlag("allow-inline",
                            "Also seal frames in place if the station requests it: headers are not encrypted, tags are short.");
    options.addValue(
        "max-overtaken", "SECONDS",
        "Reject a command if a newer message arrived more than this time before it: it was delayed in transit. 0.2 to 10.",
        "1");
    options.addValue(
        "max-age", "SECONDS|off",
        "Reject a command that may be older than this. The agent can only bound the age, by the round-trip time of the "
        "link and the time since then: choose more than twice the longest delay. 0.5 to 60.",
        "5");
    declareSigning(options);
    options.addFlag("pair", "Open the pairing window of the running agent that has this --identity, and confirm the station.");
    options.addValue(
        "role", "pilot|observer",
        "With --pair: role of the station. Without it a known station keeps its role, and you choose that of a new "
        "one; with --expect it becomes an observer.");
    PairingPrompt::declare(options); // with --json
    PairingPassphraseInput::declare(options);
    options.addFlag("check", "Check this configuration without starting: exit status 0 if it is valid, otherwise 1.");
    options.addConfig();
}

std::optional<AgentSetup> readAgent(Options &options)
{
    const auto vehicle = options.url("vehicle", link::LinkUrl::kLoopback);
    std::vector<engine::GroundLink> grounds = readGrounds(options);
    engine::KeyPaths keys{options.required("identity"), options.required("peers"), PassphraseInput::read(options).ask()};
    channel::Policy policy{options.suites("suites"), options.has("allow-research"), options.has("allow-plain")};
    if (const auto weakest = options.suite("weakest-suite"))
        policy.suites = channel::notWeakerThan(*weakest, policy.suites);
    policy.allowInline = options.has("allow-inline");
    const channel::FreshnessLimits freshness = readFreshness(options);
    SigningSetup signing = readSigning(options);
    if (std::none_of(policy.suites.begin(), policy.suites.end(), isSecure))
        options.fail("--suites: a session begins with a secure suite, so the list must contain one");
    if (options.has("allow-plain") && !grounds.empty() && std::ranges::all_of(grounds, listens))
        options.fail("--allow-plain: plain MAVLink requires a --ground that connects to the station, other than udpin");
    if (!vehicle || grounds.empty())
        return std::nullopt;
    refuseOwnPorts(options, "the agent", linksOf(*vehicle, grounds));
    return AgentSetup{{*vehicle, std::move(grounds), std::move(policy), options.has("allow-plain"), freshness},
                      std::move(keys),
                      std::move(signing)};
}

} // namespace skyseal::app
