// Provides the passphrase of a sealed key: from the desktop's keyring if it is stored there, otherwise from the operator, in
// a dialog beside the window. An entered passphrase is hashed in a thread, since that takes about a second.
#pragma once

#include "app/skyseal/passphrase_memory.h"
#include "core/engine/common/file_thread.h"
#include "core/keys/secret_file.h"

#include <QtCore/QObject>
#include <QtCore/QPointer>
#include <QtWidgets/QWidget>

#include <functional>
#include <memory>
#include <string>

namespace skyseal::ui {
class PassphraseDialog;
}

namespace skyseal::app {

/// Lives on the GUI thread.
class PassphraseQuestion : public QObject
{
    Q_OBJECT

public:
    using Identity = std::shared_ptr<const crypto::X25519KeyPair>;
    using Opened = std::function<void(const Identity &identity)>;
    using NotOpened = std::function<void(const InputError &why)>;

    /// `memory` must outlive this.
    explicit PassphraseQuestion(PassphraseMemory &memory) : m_memory(memory) {}
    /// Waits for a passphrase that is being hashed.
    ~PassphraseQuestion() override;

    /// Returns a function that gives what the keyring remembers and asks nobody. It blocks while the desktop prompts to unlock
    /// the keyring, and must not outlive this.
    keys::AskPassphrase recalled();
    /// True if the file that recalled() was last used for needs the operator.
    bool isNeeded() const { return m_needed; }

    /// Asks in a dialog beside `parent`, which stays usable, until the identity in `file` opens or the operator cancels, and
    /// calls one of the functions then. A passphrase that opens it is stored in the keyring if the operator chose so. While it
    /// is asked, the dialog comes to the front instead, and while the file is being opened, its result is waited for. Nothing
    /// is called once `parent` is deleted.
    void ask(QWidget &parent, const std::string &file, Opened opened, NotOpened notOpened);
    /// Closes the dialog, or ignores what has been entered, without calling anything.
    void withdraw();

private:
    /// The result of a passphrase.
    struct Outcome
    {
        Result<Identity, InputError> identity;
        bool wrong; ///< the passphrase does not open the file
    };

    static Outcome open(const std::string &file, const crypto::Passphrase &passphrase);
    void showDialog(bool again);
    void take();
    void finish(const Outcome &outcome, const crypto::Passphrase &passphrase, bool isToBeRemembered);

    PassphraseMemory &m_memory;
    QPointer<QWidget> m_parent;
    QPointer<ui::PassphraseDialog> m_dialog;
    std::string m_file;
    Opened m_opened;
    NotOpened m_notOpened;
    bool m_needed = false;
    int m_number = 0;       ///< of what was entered last; after withdraw() of nothing
    bool m_opening = false; ///< it is being hashed
    /// Far longer than hashing takes. Its destructor waits, so it is the last member.
    engine::FileThread m_thread{std::chrono::seconds(60)};
};

} // namespace skyseal::app
