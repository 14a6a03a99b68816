// Pairs this station with an agent: waits for it, shows both fingerprints, and adds it to the peers once they were confirmed at
// both ends.
#pragma once

#include "ui/keys/keyring_interface.h"
#include "ui/keys/pairing_interface.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>
#include <QtWidgets/QDialog>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace skyseal::ui {

class ChangedKeyWarning;
class PassphraseField;

class PairingDialog : public QDialog
{
    Q_OBJECT

public:
    PairingDialog(PairingInterface &pairing, const KeyringInterface &keyring, QWidget *parent = nullptr);
    ~PairingDialog() override;

private:
    enum class Step { Waiting, Comparing, Confirmed, Paired, Failed };

    void begin();
    void applyPassphrase();
    void showStep(Step step, const QString &text);
    void showQuestion(const PairingQuestion &question);
    void showTime();
    void check();
    void agree();

    PairingInterface &m_pairing;
    const KeyringInterface &m_keyring;
    Step m_step = Step::Waiting;
    std::optional<PairingQuestion> m_question;
    QElapsedTimer m_clock;
    QTimer m_tick;
    bool m_passphraseTyped = false; ///< edited since the pairing window was opened
    QLabel *m_text, *m_time, *m_theirs, *m_problem;
    QFormLayout *m_form;
    QLineEdit *m_name;
    PassphraseField *m_passphrase;
    QComboBox *m_role;
    ChangedKeyWarning *m_warning;
    QPushButton *m_agree, *m_differ, *m_again, *m_close;
};

} // namespace skyseal::ui
