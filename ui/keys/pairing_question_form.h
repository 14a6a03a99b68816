// The form in which the operator compares an agent that answers: its code, the name under which it will be known, its system
// id, and, on demand, the complete fingerprints of both keys.
#pragma once

#include "ui/keys/pairing_interface.h"

#include <QtWidgets/QWidget>

class QFormLayout;
class QLabel;
class QLineEdit;

namespace skyseal::ui {

class PairingQuestionForm : public QWidget
{
    Q_OBJECT

public:
    explicit PairingQuestionForm(const channel::PublicKey &ownKey, QWidget *parent = nullptr);

    /// The code is left out where a passphrase stands for it.
    void showQuestion(const PairingQuestion &question, bool withCode);
    void showFingerprints(bool visible);
    void setNameEnabled(bool enabled);
    QString name() const;

Q_SIGNALS:
    void nameChanged();

private:
    void showRow(QWidget *field, bool visible);

    QLabel *m_code, *m_system, *m_ours, *m_theirs;
    QLineEdit *m_name;
    QFormLayout *m_form;
};

} // namespace skyseal::ui
