// The public key of this station: fingerprint, text and QR code, to copy, export and compare.
#pragma once

#include "ui/keys/keyring_interface.h"

#include <QtWidgets/QGroupBox>

class QLabel;
class QPushButton;

namespace skyseal::ui {

class OwnKeyBox : public QGroupBox
{
    Q_OBJECT

public:
    explicit OwnKeyBox(KeyringInterface &keyring, QWidget *parent = nullptr);

    void refresh();

private:
    void exportKey();
    void changePassphrase();

    KeyringInterface &m_keyring;
    QString m_text;
    QLabel *m_intro, *m_fingerprint, *m_key, *m_file, *m_result, *m_code;
    QPushButton *m_copy, *m_export, *m_passphrase;
};

} // namespace skyseal::ui
