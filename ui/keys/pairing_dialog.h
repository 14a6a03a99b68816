// Pairs this station with an agent: waits for it, shows the code that both people compare (or, with a passphrase, asks only for
// the confirmation), and adds the agent to the peers once both have confirmed.
#pragma once

#include "ui/keys/keyring_interface.h"
#include "ui/keys/pairing_interface.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>
#include <QtWidgets/QDialog>

class QLabel;
class QPushButton;

namespace skyseal::ui {

class ChangedKeyWarning;
class PairingQuestionForm;
class PassphraseField;

class PairingDialog : public QDialog
{
    Q_OBJECT

public:
    PairingDialog(PairingInterface &pairing, const KeyringInterface &keyring, QWidget *parent = nullptr);
    ~PairingDialog() override;

protected:
    void changeEvent(QEvent *event) override;

private:
    enum class Step { Waiting, Comparing, Confirmed, Paired, Failed };

    void begin();
    /// Starts again with the passphrase as it is typed, unless it is the one in use.
    void applyPassphrase();
    void showStep(Step step, const QString &text);
    void showQuestion(const PairingQuestion &question);
    void showFingerprints();
    void grow();
    void refuse();
    void showTime();
    void check();
    void agree();

    PairingInterface &m_pairing;
    const KeyringInterface &m_keyring;
    Step m_step = Step::Waiting;
    std::optional<PairingQuestion> m_question;
    QElapsedTimer m_clock;
    QTimer m_tick;
    QTimer m_typing;                ///< since the last letter of the passphrase
    bool m_passphraseTyped = false; ///< edited since the pairing window was opened
    bool m_hasPassphrase = false;   ///< the open window has one
    QLabel *m_text, *m_problem, *m_time;
    PairingQuestionForm *m_agent;
    QWidget *m_passphraseRow;
    PassphraseField *m_passphrase;
    ChangedKeyWarning *m_warning;
    QPushButton *m_fingerprints, *m_agree, *m_differ, *m_again, *m_close;
};

} // namespace skyseal::ui
