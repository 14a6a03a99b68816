// Opens a sealed key by its passphrase: from the desktop's keyring if it is stored there, otherwise from the operator, who is
// asked beside the window. The passphrase is hashed in a thread, since that takes about a second.
#pragma once

#include "app/skyseal/passphrase_memory.h"
#include "core/engine/common/file_thread.h"
#include "core/keys/secret_file.h"
#include "ui/keys/passphrase_dialog.h"

#include <QtCore/QObject>
#include <QtCore/QPointer>
#include <QtWidgets/QWidget>

#include <functional>
#include <memory>
#include <string>

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

    /// The reason why a sealed key is not open as long as nobody has given its passphrase.
    static InputError notGiven(const std::string &file);

    /// True if the keyring remembers a passphrase for this file.
    bool isRemembered(const std::string &file) const;
    /// Called with true if the keyring remembers a passphrase that does not open the file, with false if it gives none.
    using Unknown = std::function<void(bool wrong)>;
    /// Opens the identity in `file` by the passphrase that the keyring remembers, asks nobody, and calls one of the functions
    /// then. Nothing is called once `parent` is deleted.
    void recall(QWidget &parent, const std::string &file, Opened opened, NotOpened notOpened, Unknown unknown);
    /// True while the keyring is waited for or a passphrase is being hashed.
    bool isOpening() const { return m_opening; }

    /// Asks in a dialog beside `parent`, which stays usable, until the identity in `file` opens or the operator cancels, and
    /// calls one of the functions then. A passphrase that opens it is stored in the keyring if the operator chose so. While it
    /// is asked, the dialog comes to the front instead, and while the file is being opened, its result is waited for. Nothing
    /// is called once `parent` is deleted. `refused`: what did not open it before.
    void ask(QWidget &parent, const std::string &file, Opened opened, NotOpened notOpened,
             ui::RefusedPassphrase refused = ui::RefusedPassphrase::None);
    /// Closes the dialog, or ignores what has been entered or recalled, without calling anything.
    void withdraw();

Q_SIGNALS:
    /// See isOpening().
    void openingChanged(bool opening);

private:
    /// The result of trying a passphrase.
    struct Outcome
    {
        Result<Identity, InputError> identity;
        bool wrong; ///< the passphrase does not open the file
    };

    using Hashed = std::function<void(const Outcome &outcome, const crypto::Passphrase &passphrase)>;

    static Outcome open(const std::string &file, const crypto::Passphrase &passphrase);
    void showDialog(ui::RefusedPassphrase refused);
    void take();
    void hash(crypto::Passphrase given, Hashed hashed);
    void finishRecalled(const Outcome &outcome);
    void finishTyped(const Outcome &outcome, const crypto::Passphrase &passphrase, bool isToBeRemembered);
    void setOpening(bool opening);

    PassphraseMemory &m_memory;
    QPointer<QWidget> m_parent;
    QPointer<ui::PassphraseDialog> m_dialog;
    std::string m_file;
    Opened m_opened;
    NotOpened m_notOpened;
    Unknown m_unknown;
    int m_number = 0; ///< of what was entered or recalled last; after withdraw() of nothing
    bool m_opening = false;
    /// Far longer than hashing takes. Its destructor waits, so it is the last member.
    engine::FileThread m_thread{std::chrono::seconds(60)};
};

} // namespace skyseal::app
