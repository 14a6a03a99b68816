#include "app/common/pairing_prompt.h"

#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "core/engine/text/pairing_text.h"
#include "core/keys/peer_line.h"
#include "core/keys/public_key_text.h"

#include <algorithm>
#include <cerrno>
#include <utility>
#include <unistd.h>

namespace skyseal::app {

namespace {

constexpr std::size_t kLongestLine = 256;

std::string withoutBlanks(std::string text)
{
    std::erase_if(text, [](char c) { return c == ' ' || c == ':' || c == '\t'; });
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string withFullStop(const QString &text)
{
    return text.toStdString() + ".";
}

std::string notPaired(const std::string &reason)
{
    return withFullStop(engine::notPairedText(QString::fromStdString(reason)));
}

} // namespace

void PairingPrompt::declare(Options &options)
{
    options.addFlag("json", "One JSON object per line on stdout.");
    options.addFlag("fingerprints", "Also show the fingerprints of both ends.");
    options.addValue("expect", "FINGERPRINT", "Confirm the peer with this fingerprint without a prompt, and refuse any other.");
    options.addFlag("replace", "With --expect: replace the key if the name is known with another one.");
    options.addValue("as", "NAME", "Name of the peer in the list, in place of the name that it claims.");
}

PairingPrompt::Settings PairingPrompt::read(Options &options)
{
    Settings out;
    out.json = options.has("json");
    out.showsFingerprints = options.has("fingerprints");
    if (options.has("expect")) {
        out.expected = withoutBlanks(options.required("expect"));
        constexpr std::size_t kDigits = 64; // complete: a key with a matching part can be found by search
        if (out.expected.size() != kDigits || out.expected.find_first_not_of("0123456789abcdef") != std::string::npos)
            options.fail("--expect: a complete fingerprint of 64 hex digits is expected");
    }
    out.replaces = options.has("replace");
    if (out.replaces && out.expected.empty())
        options.fail("--replace requires --expect; without it, you are prompted");
    if (options.has("as")) {
        out.callIt = options.required("as");
        if (const auto fits = keys::checkPeerName(out.callIt); !fits)
            options.fail("--as: " + fits.error().message.text());
    }
    return out;
}

PairingPrompt::PairingPrompt(Settings settings, QObject *parent) : QObject(parent), m_settings(std::move(settings))
{
    if (!m_settings.expected.empty())
        return;
    m_input = std::make_unique<QSocketNotifier>(STDIN_FILENO, QSocketNotifier::Read);
    connect(m_input.get(), &QSocketNotifier::activated, this, &PairingPrompt::readInput);
}

void PairingPrompt::write(const std::string &line) const
{
    remark(line);
}

void PairingPrompt::show(const std::string &title, std::initializer_list<std::string> values) const
{
    write(title);
    for (const std::string &value : values)
        write("    " + value);
}

void PairingPrompt::take(PairingStatus status)
{
    using enum PairingStatus::State;
    if (m_settings.json)
        printLine(status.toJson());
    switch (status.state) {
    case Open:
        write("The pairing window is open for " + std::to_string(status.seconds) + " s.");
        if (m_settings.showsFingerprints)
            show("The fingerprint of this device:", {keys::fingerprint(status.key)});
        if (!m_settings.decidesRole)
            write("Open the pairing window at the agent while the vehicle is disarmed: skyseal-air --pair --identity FILE");
        write("Waiting for the other end…");
        return;
    case Seen:
        m_asked = std::move(status);
        ask();
        return;
    case Confirmed: write("The other end has confirmed."); return;
    case Other: write("WARNING: " + withFullStop(engine::otherDeviceTriedText())); return;
    case Differs:
        if (!std::exchange(m_differs, true)) // the event repeats each second
            write(withFullStop(engine::passphraseDiffersText()));
        return;
    case Paired:
        m_paired = true;
        write(withFullStop(engine::pairedText(QString::fromStdString(status.name))));
        if (!status.reason.empty())
            write("WARNING: " + status.reason + ".");
        if (!m_settings.decidesRole)
            write("The role of this station, pilot (may command) or observer (may only observe), was chosen at the agent.");
        return;
    case Refused:
        m_failed = true;
        write(notPaired(status.reason));
        Q_EMIT finished(kNotReached);
        return;
    case Over:
        if (!m_paired && !m_failed)
            write(notPaired(status.reason));
        Q_EMIT finished(m_paired ? kDone : kNotReached);
        return;
    }
}

void PairingPrompt::ask()
{
    const std::string print = keys::fingerprint(m_asked->key);
    const std::string system = m_asked->systemId != 0 ? " (system ID " + std::to_string(m_asked->systemId) + ")" : "";
    write("\"" + m_asked->name + "\"" + system + " requests pairing.");
    if (m_settings.hasPassphrase)
        write("It knows the passphrase.");
    else
        show("Compare this code with the one that the other end shows:", {m_asked->code});
    if (m_settings.showsFingerprints)
        show("The fingerprint of the other end:", {print});
    if (m_asked->knownKey) {
        show("WARNING: THE KEY OF " + m_asked->name + " HAS CHANGED. The known key, and this one:",
             {keys::fingerprint(*m_asked->knownKey), print});
        write("Either the device has a new key, or this is an impersonation.");
    }
    if (m_settings.decidesRole && role())
        write("Its role here: " + std::string(keys::peerRoleText(*role())) + ".");
    if (m_settings.expected.empty()) {
        write(question());
        return;
    }
    if (withoutBlanks(print) != m_settings.expected)
        refuse("Not the expected fingerprint: refused.");
    else if (m_asked->knownKey && !m_settings.replaces)
        refuse("The fingerprint is the expected one, but a known key is replaced only with --replace: refused.");
    else
        confirm(role().value_or(channel::PeerRole::Observer));
}

std::string PairingPrompt::question() const
{
    return (m_settings.hasPassphrase ? "Is this the right device? " : "Are the codes the same? ") + answers();
}

std::string PairingPrompt::answers() const
{
    if (m_asked->knownKey)
        return "Type replace to accept the new key, or no:";
    if (!m_settings.decidesRole)
        return "Type yes or no:";
    const std::string roles = "pilot (may command), observer (may only observe) or no:";
    return role() ? "Type yes to keep its role, or " + roles : "Type its role, " + roles;
}

void PairingPrompt::readInput()
{
    char bytes[kLongestLine];
    const ssize_t count = ::read(STDIN_FILENO, bytes, sizeof bytes);
    if (count < 0 && (errno == EINTR || errno == EAGAIN))
        return;
    if (count <= 0) { // end of input: no more answers
        m_input->setEnabled(false);
        m_failed = true;
        write(notPaired("standard input has ended; use --expect FINGERPRINT to confirm without a question"));
        Q_EMIT cancelled();
        return;
    }
    m_typed.append(bytes, static_cast<std::size_t>(count));
    for (std::size_t end = m_typed.find('\n'); end != std::string::npos; end = m_typed.find('\n')) {
        const std::string line = m_typed.substr(0, end);
        m_typed.erase(0, end + 1);
        answer(line);
    }
    if (m_typed.size() > kLongestLine)
        m_typed.clear();
}

void PairingPrompt::answer(const std::string &line)
{
    if (!m_asked)
        return; // input before the question is not an answer
    const std::string word = withoutBlanks(line);
    const auto chosen = choosesRole() ? keys::peerRoleFromText(word) : std::nullopt;
    if (word == "no")
        refuse("Refused.");
    else if (chosen)
        confirm(*chosen);
    else if (word == (m_asked->knownKey ? "replace" : "yes") && (role() || !m_settings.decidesRole))
        confirm(role().value_or(channel::PeerRole::Observer));
    else if (word == "yes")
        write((m_asked->knownKey ? "\"yes\" does not replace a key. " : "\"yes\" is not enough: the station needs a role. ")
              + answers());
    else
        write("\"" + line + "\" is not an answer. " + answers());
}

/// The role that is given by an option or known here.
std::optional<channel::PeerRole> PairingPrompt::role() const
{
    return m_settings.role ? m_settings.role : m_asked->knownRole;
}

bool PairingPrompt::choosesRole() const
{
    return m_settings.decidesRole && !m_asked->knownKey;
}

void PairingPrompt::refuse(const std::string &text)
{
    m_asked.reset();
    Q_EMIT refused();
    write(text);
}

void PairingPrompt::confirm(channel::PeerRole role)
{
    const Answer out{m_asked->key, m_asked->name, role, m_asked->knownKey.has_value()};
    m_asked.reset();
    write("Confirmed here; the other end must confirm as well.");
    Q_EMIT confirmed(out);
}

} // namespace skyseal::app

#include "moc_pairing_prompt.cpp"
