#include "ui/links/link_dialog.h"

#include "core/link/link_url.h"
#include "ui/text/words.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

namespace skyseal::ui {

using link::LinkScheme;
using link::LinkUrl;

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
    m_kind->addItem(tr("UDP, listen for vehicles"), static_cast<int>(LinkScheme::UdpIn));
    m_kind->addItem(tr("UDP, send to an address"), static_cast<int>(LinkScheme::UdpOut));
    m_kind->addItem(tr("TCP, connect to an address"), static_cast<int>(LinkScheme::Tcp));
    m_kind->addItem(tr("TCP, listen for connections"), static_cast<int>(LinkScheme::TcpIn));
    m_kind->addItem(tr("Serial radio"), static_cast<int>(LinkScheme::Serial));
    m_kind->addItem(tr("Recorded log"), static_cast<int>(LinkScheme::Tlog));
    m_host = new QLineEdit(this);
    m_host->setObjectName(QStringLiteral("linkHost"));
    m_port = new QSpinBox(this);
    m_port->setObjectName(QStringLiteral("linkPort"));
    m_port->setRange(1, 65535);
    m_path = new QLineEdit(this);
    m_path->setObjectName(QStringLiteral("linkPath"));
    m_browse = new QPushButton(tr("Browse …"), this);
    m_browse->setAccessibleName(tr("Browse for the log file"));
    m_baud = new QComboBox(this);
    m_baud->setObjectName(QStringLiteral("linkBaud"));
    m_baud->setEditable(true);
    m_baud->addItems({QStringLiteral("57600"), QStringLiteral("115200"), QStringLiteral("230400"), QStringLiteral("460800"),
                      QStringLiteral("921600")});
    m_result = new QLabel(this);
    m_result->setObjectName(QStringLiteral("linkResult"));
    m_result->setAccessibleName(tr("The link that this makes"));
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
    grid->addWidget(m_result, row++, 0, 1, 3);
    grid->addWidget(m_buttons, row, 0, 1, 3);
    setMinimumWidth(56 * kGrid);

    connect(m_kind, &QComboBox::currentIndexChanged, this, &LinkDialog::showKind);
    connect(m_host, &QLineEdit::textChanged, this, &LinkDialog::check);
    connect(m_path, &QLineEdit::textChanged, this, &LinkDialog::check);
    connect(m_port, &QSpinBox::valueChanged, this, &LinkDialog::check);
    connect(m_baud, &QComboBox::currentTextChanged, this, &LinkDialog::check);
    connect(m_browse, &QPushButton::clicked, this, &LinkDialog::browse);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill(url);
    showKind();
}

void LinkDialog::fill(const QString &url)
{
    m_host->setText(QStringLiteral("0.0.0.0"));
    m_port->setValue(14550);
    const auto parsed = LinkUrl::parse(url.toStdString());
    if (!parsed)
        return;
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(parsed->scheme())));
    m_path->setText(fromStd(parsed->path()));
    if (!parsed->host().empty()) {
        m_host->setText(fromStd(parsed->host()));
        m_port->setValue(parsed->port());
    }
}

void LinkDialog::showKind()
{
    const auto kind = static_cast<LinkScheme>(m_kind->currentData().toInt());
    const bool network = kind != LinkScheme::Serial && kind != LinkScheme::Tlog;
    for (QWidget *widget : std::initializer_list<QWidget *>{m_host, m_hostLabel, m_port, m_portLabel})
        widget->setVisible(network);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_path, m_pathLabel})
        widget->setVisible(!network);
    m_browse->setVisible(kind == LinkScheme::Tlog);
    m_baud->setVisible(kind == LinkScheme::Serial);
    m_baudLabel->setVisible(kind == LinkScheme::Serial);
    const bool listens = kind == LinkScheme::UdpIn || kind == LinkScheme::TcpIn;
    if (network && listens && m_host->text() == QLatin1String("127.0.0.1"))
        m_host->setText(QStringLiteral("0.0.0.0"));
    if (network && !listens && m_host->text() == QLatin1String("0.0.0.0"))
        m_host->setText(QStringLiteral("127.0.0.1"));
    m_pathLabel->setText(kind == LinkScheme::Serial ? tr("&Device") : tr("&File"));
    check();
}

QString LinkDialog::url() const
{
    const auto kind = static_cast<LinkScheme>(m_kind->currentData().toInt());
    const QString scheme = QLatin1String(link::name(kind));
    if (kind == LinkScheme::Serial)
        return QStringLiteral("%1:%2:%3").arg(scheme, m_path->text(), m_baud->currentText());
    if (kind == LinkScheme::Tlog)
        return QStringLiteral("%1:%2").arg(scheme, m_path->text());
    const bool literal = m_host->text().contains(QLatin1Char(':')) && !m_host->text().startsWith(QLatin1Char('['));
    return QStringLiteral("%1:%2:%3")
        .arg(scheme, literal ? QStringLiteral("[%1]").arg(m_host->text()) : m_host->text())
        .arg(m_port->value());
}

QString LinkDialog::problem() const
{
    const auto parsed = LinkUrl::parse(url().toStdString());
    return parsed ? QString() : fromStd(parsed.error().message);
}

void LinkDialog::check()
{
    const QString wrong = problem();
    m_result->setText(wrong.isEmpty() ? url() : wrong);
    QPalette colors = palette();
    if (!wrong.isEmpty())
        colors.setColor(QPalette::WindowText, stateColors(palette()).alarm);
    m_result->setPalette(colors);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(wrong.isEmpty());
}

void LinkDialog::browse()
{
    const QString file
        = QFileDialog::getOpenFileName(this, tr("Replay a log"), {}, tr("Telemetry logs (*.tlog);;All files (*)"));
    if (!file.isEmpty())
        m_path->setText(file);
}

} // namespace skyseal::ui
