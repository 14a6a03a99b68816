// Asks for the passphrase of this station's key.
#pragma once

#include <QtWidgets/QDialog>

class QLineEdit;

namespace skyseal::ui {

class PassphraseDialog : public QDialog
{
    Q_OBJECT

public:
    /// `again`: the one that was typed before did not open the file.
    PassphraseDialog(const QString &file, bool again, QWidget *parent = nullptr);

    /// What was typed, taken out of the dialog.
    QByteArray takePassphrase();

private:
    QLineEdit *m_edit;
};

} // namespace skyseal::ui
