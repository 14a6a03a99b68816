// The terminal dialog of a pairing, used by the agent and the station: shows the code and asks whether the other end shows the
// same one; the agent's side asks for the role of the station as well.
#pragma once

#include "app/common/options.h"
#include "app/common/pairing_status.h"

#include <QtCore/QObject>
#include <QtCore/QSocketNotifier>

#include <initializer_list>
#include <memory>

namespace skyseal::app {

/// Reads answers from standard input, line by line, and writes to standard error; with --json, statuses to standard output.
class PairingPrompt : public QObject
{
    Q_OBJECT

public:
    /// The user's decision about the peer.
    struct Answer
    {
        channel::PublicKey key{};
        std::string name; ///< its name here
        channel::PeerRole role = channel::PeerRole::Observer;
        bool replace = false; ///< replace the key known by that name
    };
    struct Settings
    {
        bool json = false;
        std::string expected;     ///< the only fingerprint to confirm, without asking; empty = ask
        std::string callIt;       ///< name for the peer (see statusOf); empty = the name it claims
        bool replaces = false;    ///< with `expected`: replace a key known by that name
        bool decidesRole = false; ///< the agent's side: it decides the role of the peer
        /// The granted role; if empty, a known peer keeps its role, and the user decides on a new one (`expected`: observer).
        std::optional<channel::PeerRole> role;
        bool hasPassphrase = false; ///< then there is no code to compare
        bool showsFingerprints = false;
    };

    /// --json, --fingerprints, --expect, --replace and --as.
    static void declare(Options &options);
    static Settings read(Options &options);

    explicit PairingPrompt(Settings settings, QObject *parent = nullptr);

    void take(PairingStatus status);

Q_SIGNALS:
    void confirmed(const skyseal::app::PairingPrompt::Answer &answer);
    void refused();
    /// The user cancelled.
    void cancelled();
    /// The pairing has ended; with the exit status.
    void finished(int status);

private:
    void ask();
    void readInput();
    void answer(const std::string &line);
    std::optional<channel::PeerRole> role() const;
    bool choosesRole() const;
    std::string question() const;
    /// The answers that the question accepts, as an instruction.
    std::string answers() const;
    void refuse(const std::string &text);
    void confirm(channel::PeerRole role);
    void write(const std::string &line) const;
    /// One line for the title and one for each value, indented.
    void show(const std::string &title, std::initializer_list<std::string> values) const;

    Settings m_settings;
    std::unique_ptr<QSocketNotifier> m_input;
    std::string m_typed;
    std::optional<PairingStatus> m_asked; ///< the open question
    bool m_differs = false;
    bool m_paired = false;
    bool m_failed = false;
};

} // namespace skyseal::app
