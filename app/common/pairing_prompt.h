// The conversation of a pairing in a terminal: shows the fingerprints and asks whether they are the same ones at the other
// end, as ssh asks for a new host. The agent's side and the station's side have the same one.
#pragma once

#include "app/common/options.h"
#include "app/common/pairing_status.h"

#include <QtCore/QObject>
#include <QtCore/QSocketNotifier>

#include <memory>

namespace skyseal::app {

/// Reads answers from standard input, line by line, and speaks on standard error; with --json the status go to standard output.
class PairingPrompt : public QObject
{
    Q_OBJECT

public:
    /// What the person decides about the other end.
    struct Answer
    {
        channel::PublicKey key{};
        std::string name; ///< how it is to be called here
        channel::PeerRole role = channel::PeerRole::Pilot;
        bool replace = false; ///< the key known by that name
    };
    struct Settings
    {
        bool json = false;
        std::string expected;     ///< fingerprint that is confirmed without a question, and no other; empty = ask
        std::string callIt;       ///< name to be given to the other end (statusOf wants it); empty = what it calls itself
        bool replaces = false;    ///< with `expected`: a key known by that name, too
        bool decidesRole = false; ///< the agent's side: whether the other one may command
        /// What is granted there; otherwise who is known keeps the role, and who is new gets what it asks for.
        std::optional<channel::PeerRole> role;
        /// The station's side: what it asks to be at the agent.
        std::optional<channel::PeerRole> asks;
    };

    /// --json, --expect, --replace and --as.
    static void declare(Options &options);
    static Settings read(Options &options);

    explicit PairingPrompt(Settings settings, QObject *parent = nullptr);

    void take(PairingStatus status);

Q_SIGNALS:
    void confirmed(const skyseal::app::PairingPrompt::Answer &answer);
    void refused();
    /// The person does not want to go on.
    void cancelled();
    /// It is over; an exit status.
    void finished(int status);

private:
    void ask();
    void hear();
    void answer(const std::string &line);
    channel::PeerRole role() const;
    bool mayBeObserver() const;
    void refuse(const std::string &words);
    void confirm(channel::PeerRole role);
    void say(const std::string &words) const;

    Settings m_settings;
    std::unique_ptr<QSocketNotifier> m_input;
    std::string m_typed;
    std::optional<PairingStatus> m_asked; ///< the question that is open
    bool m_differs = false;
    bool m_paired = false;
    bool m_failed = false;
};

} // namespace skyseal::app
