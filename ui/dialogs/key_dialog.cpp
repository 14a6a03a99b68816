#include "ui/dialogs/key_dialog.h"

#include "core/keys/public_key_text.h"
#include "ui/text/words.h"
#include "ui/theme/grid.h"

#include <QtGui/QClipboard>
#include <QtGui/QFontDatabase>
#include <QtGui/QGuiApplication>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

#include <qrencode.h>

#include <memory>

namespace skyseal::ui {

QImage qrImage(const QString &text)
{
    constexpr int kQuietZone = 4;
    const std::unique_ptr<QRcode, decltype(&QRcode_free)> code(
        QRcode_encodeString(text.toUtf8().constData(), 0, QR_ECLEVEL_M, QR_MODE_8, 1), &QRcode_free);
    if (!code)
        return {};
    const int side = code->width + 2 * kQuietZone;
    QImage image(side, side, QImage::Format_RGB32);
    image.fill(Qt::white);
    for (int y = 0; y < code->width; ++y)
        for (int x = 0; x < code->width; ++x)
            if (code->data[y * code->width + x] & 1)
                image.setPixel(x + kQuietZone, y + kQuietZone, 0xff000000);
    return image;
}

KeyDialog::KeyDialog(const std::optional<channel::PublicKey> &key, const QString &identityFile, const QString &peersFile,
                     QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("keyDialog"));
    setWindowTitle(tr("Own key"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    auto *intro = new QLabel(
        key ? tr("Give this public key to the agent beside the vehicle. It is no secret, but make sure that it is this one "
                 "that arrives there.")
            : tr("This station has no identity: it can only speak plain MAVLink."),
        this);
    intro->setWordWrap(true);
    column->addWidget(intro);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    if (key) {
        const QString text = fromStd(keys::publicKeyText(*key));
        auto *value = new QLabel(text, this);
        value->setObjectName(QStringLiteral("ownKey"));
        value->setAccessibleName(tr("Own public key"));
        value->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
        value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        column->addWidget(value);
        auto *print = new QLabel(tr("Fingerprint\n%1").arg(fromStd(keys::fingerprint(*key))), this);
        print->setObjectName(QStringLiteral("ownFingerprint"));
        print->setWordWrap(true);
        print->setTextInteractionFlags(Qt::TextSelectableByMouse);
        column->addWidget(print);
        const QImage code = qrImage(text);
        if (!code.isNull()) {
            auto *picture = new QLabel(this);
            picture->setAccessibleName(tr("The key as a QR code"));
            picture->setPixmap(
                QPixmap::fromImage(code.scaled(code.size() * 5, Qt::KeepAspectRatio, Qt::FastTransformation)));
            column->addWidget(picture, 0, Qt::AlignHCenter);
        }
        QPushButton *copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
        connect(copy, &QPushButton::clicked, this, [text] { QGuiApplication::clipboard()->setText(text); });
    }
    auto *files = new QLabel(tr("Identity: %1\nKnown peers: %2").arg(identityFile.isEmpty() ? tr("none") : identityFile,
                                                                   peersFile.isEmpty() ? tr("none") : peersFile), this);
    files->setForegroundRole(QPalette::PlaceholderText);
    files->setTextInteractionFlags(Qt::TextSelectableByMouse);
    files->setWordWrap(true);
    column->addWidget(files);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setMinimumWidth(64 * kGrid);
}

} // namespace skyseal::ui
