#include "ui/links/link_dialog.h"

#include "core/crypto/mavsec_cipher.h"
#include "core/base/hex.h"
#include "core/base/research.h"
#include "core/link/link_url.h"
#include "ui/ask_file.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QCoreApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

#include <utility>

namespace skyseal::ui {

using link::LinkTarget;
using link::LinkType;
using link::LinkUrl;
using crypto::MavsecCipher;

LinkDialog::LinkDialog(const QString &url, QWidget *parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("linkDialog"));
    setWindowTitle(tr("Connect"));
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    grid->setHorizontalSpacing(2 * kGrid);
    grid->setVerticalSpacing(kGrid);
    grid->setColumnStretch(1, 1);

    m_kind = new QComboBox(this);
    m_kind->setObjectName(QStringLiteral("linkKind"));
    for (const LinkType &each : link::linkTypes()) {
        m_kind->addItem(QCoreApplication::translate(LinkType::kTextContext, each.label), QLatin1String(each.scheme));
        m_kind->setItemData(m_kind->count() - 1, QCoreApplication::translate(LinkType::kTextContext, each.hint),
                            Qt::ToolTipRole);
    }
    m_host = new QLineEdit(this);
    m_host->setObjectName(QStringLiteral("linkHost"));
    m_port = new QSpinBox(this);
    m_port->setObjectName(QStringLiteral("linkPort"));
    m_port->setRange(1, 999'999); // beyond the greatest port, which is then refused: a field that drops a digit names another
    m_path = new QLineEdit(this);
    m_path->setObjectName(QStringLiteral("linkPath"));
    m_browse = new QPushButton(tr("Browse…"), this);
    m_browse->setAccessibleName(tr("Browse for the log file"));
    m_baud = new QComboBox(this);
    m_baud->setObjectName(QStringLiteral("linkBaud"));
    m_baud->setEditable(true);
    m_baud->addItems({QStringLiteral("57600"), QStringLiteral("115200"), QStringLiteral("230400"), QStringLiteral("460800"),
                      QStringLiteral("921600")});
    m_protection = new QComboBox(this);
    m_protection->setObjectName(QStringLiteral("linkProtection"));
    m_protection->addItem(tr("Sealed, or plain MAVLink"));
    if (kResearch) {
        m_protection->addItem(tr("INSECURE: MAVSec 2019, ChaCha20, receive only"), int(MavsecCipher::Kind::ChaCha20));
        m_protection->addItem(tr("INSECURE: MAVSec 2019, AES-256-CTR, receive only"), int(MavsecCipher::Kind::Aes256Ctr));
    }
    m_key = new QLineEdit(this);
    m_key->setObjectName(QStringLiteral("linkKeyFile"));
    m_key->setPlaceholderText(tr("the published key"));
    m_nonce = new QLineEdit(this);
    m_nonce->setObjectName(QStringLiteral("linkNonce"));
    m_nonce->setPlaceholderText(tr("the published nonce"));
    m_counter = new QLineEdit(this);
    m_counter->setObjectName(QStringLiteral("linkCounter"));
    m_counter->setPlaceholderText(tr("the published counter, %1").arg(MavsecCipher::kPublishedCounter));
    m_browseKey = new QPushButton(tr("Browse…"), this);
    m_browseKey->setAccessibleName(tr("Browse for the key file"));
    m_result = new QLabel(this);
    m_result->setObjectName(QStringLiteral("linkResult"));
    m_result->setAccessibleName(tr("URL of the link"));
    m_result->setWordWrap(true);
    m_result->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Connect"));

    int row = 0;
    const auto line = [&](const QString &name, QWidget *field, int columns = 2) {
        auto *label = new QLabel(name, this);
        label->setBuddy(field);
        QString plain = name;
        field->setAccessibleName(plain.remove(QLatin1Char('&')));
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row++, 1, 1, columns);
        return label;
    };
    line(tr("&Kind"), m_kind);
    m_hostLabel = line(tr("&Host"), m_host);
    m_portLabel = line(tr("&Port"), m_port);
    m_pathLabel = line(tr("&Device or file"), m_path, 1);
    grid->addWidget(m_browse, row - 1, 2);
    m_baudLabel = line(tr("&Baud"), m_baud);
    line(tr("P&rotection"), m_protection);
    m_keyLabel = line(tr("K&ey file"), m_key, 1);
    grid->addWidget(m_browseKey, row - 1, 2);
    m_nonceLabel = line(tr("&Nonce"), m_nonce);
    m_counterLabel = line(tr("C&ounter"), m_counter);
    grid->addWidget(m_result, row++, 0, 1, 3);
    auto *how = smallPrint(tr("A link stays open until Skyseal closes. The one to open at start is in File → Settings."), this);
    how->setObjectName(QStringLiteral("linkHowLong"));
    grid->addWidget(how, row++, 0, 1, 3);
    grid->addWidget(m_buttons, row, 0, 1, 3);
    setMinimumWidth(56 * kGrid);

    connect(m_kind, &QComboBox::currentIndexChanged, this, &LinkDialog::showKind);
    connect(m_host, &QLineEdit::textChanged, this, &LinkDialog::check);
    connect(m_path, &QLineEdit::textChanged, this, &LinkDialog::check);
    connect(m_port, &QSpinBox::valueChanged, this, &LinkDialog::check);
    connect(m_baud, &QComboBox::currentTextChanged, this, &LinkDialog::check);
    connect(m_protection, &QComboBox::currentIndexChanged, this, &LinkDialog::showProtection);
    connect(m_nonce, &QLineEdit::textChanged, this, &LinkDialog::check);
    connect(m_counter, &QLineEdit::textChanged, this, &LinkDialog::check);
    connect(m_browseKey, &QPushButton::clicked, this, &LinkDialog::browseKey);
    connect(m_browse, &QPushButton::clicked, this, &LinkDialog::browse);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill(url);
    showKind();
    showProtection();
}

void LinkDialog::fill(const QString &url)
{
    m_host->setText(fromStd(LinkUrl::kAnyHost));
    m_port->setValue(14550);
    const auto parsed = LinkUrl::parse(url.toStdString());
    if (!parsed)
        return;
    m_kind->setCurrentIndex(m_kind->findData(QLatin1String(parsed->type().scheme)));
    m_path->setText(fromStd(parsed->path()));
    if (parsed->type().target == LinkTarget::HostPort) {
        m_host->setText(fromStd(parsed->host()));
        m_port->setValue(parsed->port());
    }
    if (parsed->type().target == LinkTarget::DeviceBaud)
        m_baud->setCurrentText(QString::number(parsed->baud()));
}

const LinkType &LinkDialog::type() const
{
    return *link::findLinkType(m_kind->currentData().toString().toStdString());
}

void LinkDialog::showKind()
{
    const LinkTarget target = type().target;
    const bool isNetwork = target == LinkTarget::HostPort;
    for (QWidget *widget : std::initializer_list<QWidget *>{m_host, m_hostLabel, m_port, m_portLabel})
        widget->setVisible(isNetwork);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_path, m_pathLabel})
        widget->setVisible(!isNetwork);
    m_browse->setVisible(target == LinkTarget::File);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_baud, m_baudLabel})
        widget->setVisible(target == LinkTarget::DeviceBaud);
    const QString any = fromStd(LinkUrl::kAnyHost), loopback = fromStd(LinkUrl::kLoopback);
    const bool isListening = type().traits.isListening;
    if (isNetwork && m_host->text() == (isListening ? loopback : any))
        m_host->setText(isListening ? any : loopback);
    m_pathLabel->setText(target == LinkTarget::DeviceBaud ? tr("&Device") : tr("&File"));
    check();
}

QString LinkDialog::url() const
{
    const QString scheme = QLatin1String(type().scheme);
    switch (type().target) {
    case LinkTarget::DeviceBaud: return QStringLiteral("%1:%2:%3").arg(scheme, m_path->text(), m_baud->currentText());
    case LinkTarget::File: return QStringLiteral("%1:%2").arg(scheme, m_path->text());
    case LinkTarget::HostPort: break;
    }
    const bool isLiteral = m_host->text().contains(QLatin1Char(':')) && !m_host->text().startsWith(QLatin1Char('['));
    return QStringLiteral("%1:%2:%3")
        .arg(scheme, isLiteral ? QStringLiteral("[%1]").arg(m_host->text()) : m_host->text())
        .arg(m_port->value());
}

std::optional<engine::MavsecSettings> LinkDialog::mavsec() const
{
    if (!m_protection->currentData().isValid())
        return std::nullopt;
    engine::MavsecSettings settings;
    settings.kind = static_cast<MavsecCipher::Kind>(m_protection->currentData().toInt());
    settings.keyFile = m_key->text().toStdString();
    settings.nonceHex = m_nonce->text().remove(QLatin1Char(' ')).toStdString();
    if (settings.kind == MavsecCipher::Kind::ChaCha20 && !m_counter->text().isEmpty())
        settings.counter = m_counter->text().toUInt();
    return settings;
}

void LinkDialog::showProtection()
{
    const bool asked = m_protection->currentData().isValid();
    for (QWidget *widget : std::initializer_list<QWidget *>{m_key, m_keyLabel, m_browseKey, m_nonce, m_nonceLabel})
        widget->setVisible(asked);
    // AES-256-CTR takes its counter from the nonce.
    const bool counts = asked && mavsec()->kind == MavsecCipher::Kind::ChaCha20;
    for (QWidget *widget : std::initializer_list<QWidget *>{m_counter, m_counterLabel})
        widget->setVisible(counts);
    check();
}

void LinkDialog::setOwnLinks(std::vector<LinkUrl> own)
{
    m_own = std::move(own);
    check();
}

/// Why it could never work beside the links of this program; empty if it can.
QString LinkDialog::ownLinkProblem(const LinkUrl &wanted) const
{
    for (const LinkUrl &own : m_own) {
        const QString name = fromStd(own.toText());
        if (wanted.reaches(own))
            return tr("Skyseal itself listens there, with %1").arg(name);
        if (own.reaches(wanted))
            return tr("Skyseal itself sends there, with %1").arg(name);
        if (wanted.sharesPort(own))
            return tr("Skyseal already listens there, with %1").arg(name);
    }
    return {};
}

QString LinkDialog::problem() const
{
    const auto parsed = LinkUrl::parse(url().toStdString());
    if (!parsed)
        return reasonText(parsed.error().message);
    if (QString own = ownLinkProblem(*parsed); !own.isEmpty())
        return own;
    const auto settings = mavsec();
    const auto digits = settings ? 2 * MavsecCipher::nonceLength(settings->kind) : 0;
    const bool wrongNonce = settings && !settings->nonceHex.empty()
        && (settings->nonceHex.size() != digits || !fromHex(settings->nonceHex));
    if (wrongNonce)
        return tr("The nonce must have %1 hex digits").arg(digits);
    bool isNumber = false;
    static_cast<void>(m_counter->text().toUInt(&isNumber));
    const bool counts = settings && settings->kind == MavsecCipher::Kind::ChaCha20 && !m_counter->text().isEmpty();
    return counts && !isNumber ? tr("The counter must be a number from 0 to 4294967295") : QString();
}

void LinkDialog::check()
{
    const QString wrong = problem();
    const bool insecure = mavsec().has_value();
    const QString good = insecure
        ? tr("%1\nINSECURE: anyone can read, change and forge this stream. Nothing is sent.").arg(url())
        : url();
    m_result->setText(wrong.isEmpty() ? good : wrong);
    QPalette colors = palette();
    if (!wrong.isEmpty() || insecure)
        colors.setColor(QPalette::WindowText, stateColors(palette()).alarm);
    m_result->setPalette(colors);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(wrong.isEmpty());
}

void LinkDialog::browseKey()
{
    askFile(*this, {.title = tr("Key of the stream")}, [this](const QString &file) { m_key->setText(file); });
}

void LinkDialog::browse()
{
    askFile(*this, {.title = tr("Replay a log"), .kinds = tr("Telemetry logs (*.tlog);;All files (*)")},
            [this](const QString &file) { m_path->setText(file); });
}

} // namespace skyseal::ui

#include "moc_link_dialog.cpp"
