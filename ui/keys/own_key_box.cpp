#include "ui/keys/own_key_box.h"

#include "core/keys/public_key_text.h"
#include "ui/ask_file.h"
#include "ui/keys/change_passphrase_dialog.h"
#include "ui/keys/fingerprint_text.h"
#include "ui/keys/qr_image.h"
#include "ui/text/vehicle_text.h"
#include "ui/modeless.h"
#include "ui/theme/grid.h"

#include <QtGui/QClipboard>
#include <QtGui/QGuiApplication>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

namespace skyseal::ui {

OwnKeyBox::OwnKeyBox(KeyringInterface &keyring, QWidget *parent) : QGroupBox(tr("This station"), parent), m_keyring(keyring)
{
    const auto label = [this](const char *name) {
        auto *out = new QLabel(this);
        out->setObjectName(QLatin1String(name));
        out->setWordWrap(true);
        out->setTextFormat(Qt::PlainText);
        return out;
    };
    m_intro = label("ownIntro");
    m_fingerprint = fixedWidthLabel({}, "ownFingerprint", tr("Own fingerprint"), this);
    m_key = fixedWidthLabel({}, "ownKey", tr("Own public key"), this);
    m_file = label("ownFile");
    m_file->setForegroundRole(QPalette::PlaceholderText);
    m_file->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_result = label("ownResult");
    m_code = new QLabel(this);
    m_code->setObjectName(QStringLiteral("ownCode"));
    m_code->setAccessibleName(tr("The public key as a QR code"));
    m_copy = new QPushButton(tr("&Copy the public key"), this);
    m_copy->setObjectName(QStringLiteral("ownCopy"));
    m_export = new QPushButton(tr("E&xport…"), this);
    m_export->setObjectName(QStringLiteral("ownExport"));
    m_export->setAccessibleName(tr("Export the public key to a file"));

    m_passphrase = new QPushButton(this);
    m_passphrase->setObjectName(QStringLiteral("ownPassphrase"));
    for (QPushButton *button : {m_copy, m_export, m_passphrase})
        button->setAutoDefault(false);

    auto *tools = new QHBoxLayout;
    tools->setSpacing(kGrid);
    tools->addWidget(m_copy);
    tools->addWidget(m_export);
    tools->addWidget(m_passphrase);
    tools->addWidget(m_result, 1);
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, 2 * kGrid);
    grid->setHorizontalSpacing(2 * kGrid);
    grid->setVerticalSpacing(kGrid);
    grid->addWidget(m_intro, 0, 0);
    grid->addWidget(m_fingerprint, 1, 0);
    grid->addWidget(m_key, 2, 0);
    grid->addLayout(tools, 3, 0);
    grid->addWidget(m_file, 4, 0);
    grid->addWidget(m_code, 0, 1, 5, 1, Qt::AlignTop | Qt::AlignRight);
    grid->setColumnStretch(0, 1);

    connect(m_copy, &QPushButton::clicked, this, [this] {
        QGuiApplication::clipboard()->setText(m_text);
        m_result->setText(tr("copied"));
    });
    connect(m_export, &QPushButton::clicked, this, &OwnKeyBox::exportKey);
    connect(m_passphrase, &QPushButton::clicked, this, &OwnKeyBox::changePassphrase);
    connect(&keyring, &KeyringInterface::passphraseDone, this, [this](const QString &problem) {
        if (problem.isEmpty())
            m_result->setText(m_keyring.ownKey().sealed ? tr("sealed") : tr("no longer sealed"));
    });
    refresh();
}

void OwnKeyBox::refresh()
{
    const OwnKey own = m_keyring.ownKey();
    const bool has = own.publicKey.has_value();
    for (QWidget *widget : std::initializer_list<QWidget *>{m_fingerprint, m_key, m_code, m_copy, m_export, m_passphrase})
        widget->setVisible(has);
    m_file->setVisible(!own.file.isEmpty());
    if (!has) {
        m_intro->setText(own.problem.isEmpty() ? tr("This station has no key: it can use only plain MAVLink. Create one with\n"
                                                    "skyseal-cli keys new --out FILE\nand start with --identity FILE.")
                                               : tr("No key is in use: %1").arg(own.problem));
        m_file->setText(own.file);
        return;
    }
    const QString text = fromStd(keys::publicKeyText(*own.publicKey));
    m_intro->setText(
        tr("The other end needs this public key. It is not secret, but compare its fingerprint there with this one:"));
    m_fingerprint->setText(fingerprintLines(*own.publicKey));
    m_key->setText(text);
    m_file->setText(own.sealed ? tr("%1, sealed with a passphrase").arg(own.file)
                               : tr("%1, not sealed: anyone who copies the file has the key").arg(own.file));
    m_passphrase->setText(own.sealed ? tr("Change the pa&ssphrase…") : tr("Set a pa&ssphrase…"));
    m_passphrase->setAccessibleName(m_passphrase->text().remove(QLatin1Char('&')));
    if (text == m_text)
        return;
    m_text = text;
    m_result->clear();
    constexpr int kModule = 3; // pixels
    const QImage code = qrImage(text);
    if (!code.isNull())
        m_code->setPixmap(QPixmap::fromImage(code.scaled(code.size() * kModule, Qt::KeepAspectRatio, Qt::FastTransformation)));
}

void OwnKeyBox::changePassphrase()
{
    auto *dialog = new ChangePassphraseDialog(m_keyring, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    showModeless(*dialog);
}

void OwnKeyBox::exportKey()
{
    askFile(*this,
            {.title = tr("Export the public key"),
             .kinds = tr("Public keys (*.pub);;All files (*)"),
             .start = QStringLiteral("station.pub"),
             .use = FileQuestion::Use::Write},
            [this](const QString &file) {
                const auto written = m_keyring.exportPublicKey(file);
                m_result->setText(written ? tr("written to %1").arg(file) : reasonText(written.error().reason()));
            });
}

} // namespace skyseal::ui

#include "moc_own_key_box.cpp"
