#include "ui/links/gateway_section.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/state_text.h"
#include "ui/control_action.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QEvent>
#include <QtCore/QRegularExpression>
#include <QtCore/QSignalBlocker>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeView>

#include <algorithm>

namespace skyseal::ui {

namespace {

QString served(std::size_t stations)
{
    return stations == 0 ? GatewaySection::tr("no station is connected")
        : stations == 1  ? GatewaySection::tr("one station")
                         : GatewaySection::tr("%1 stations").arg(stations);
}

/// The addresses in a text, with their options. A name among these may have spaces.
QStringList addressesIn(const QString &text)
{
    static const QRegularExpression kBetween(QStringLiteral("\\s+(?=[A-Za-z]+:)"));
    return text.trimmed().split(kBetween);
}

/// An address with these rights; all are those without write=.
QString withRights(const QString &address, const engine::WriteRights &rights)
{
    QStringList kept;
    bool isOfWrite = false;
    for (const QString &part : address.split(QLatin1Char(','))) {
        isOfWrite = part.startsWith(QLatin1String("write=")) || (isOfWrite && !part.contains(QLatin1Char('=')));
        if (!isOfWrite)
            kept.append(part);
    }
    if (rights != engine::WriteRights::all())
        kept.append(QLatin1String("write=") + fromStd(rights.toText()));
    return kept.join(QLatin1Char(','));
}

/// The classes that stations may write at some of these addresses, as keywords.
QStringList writtenAt(const QString &addresses)
{
    QStringList out;
    for (const QString &address : addressesIn(addresses)) {
        const auto config = engine::ServeConfig::parse(address.toStdString(), engine::WriteRights::all());
        if (config && config->write.any())
            out += QString::fromStdString(config->write.toText()).split(QLatin1Char(','));
    }
    return out;
}

bool mayCommand(const QStringList &classes)
{
    return classes.contains(QLatin1String("all")) || classes.contains(QLatin1String("command"))
        || classes.contains(QLatin1String("rc"));
}

/// Empty for none.
QString consequenceOf(const QStringList &classes)
{
    const auto may = [&](const char *keyword) {
        return classes.contains(QLatin1String("all")) || classes.contains(QLatin1String(keyword));
    };
    QStringList parts;
    if (mayCommand(classes))
        parts << GatewaySection::tr("arm, fly and stop the vehicles");
    if (may("mission"))
        parts << GatewaySection::tr("change missions, fences and rally points");
    if (may("param"))
        parts << GatewaySection::tr("change parameters");
    if (may("ftp"))
        parts << GatewaySection::tr("change files and logs");
    return parts.isEmpty()
        ? QString()
        : GatewaySection::tr("Other stations can do as this window: %1.").arg(parts.join(QStringLiteral(" · ")));
}

/// The link that best describes all of them: one with a problem, or else one that is not ready yet.
const engine::LinkSnapshot &worstOf(const std::vector<engine::LinkSnapshot> &links)
{
    return *std::ranges::max_element(links, {}, [](const engine::LinkSnapshot &link) {
        const bool isReady = link.phase == engine::LinkPhase::Listening || link.phase == engine::LinkPhase::Connected;
        return link.problem.empty() ? (isReady ? 0 : 1) : 2;
    });
}

} // namespace

GatewaySection::GatewaySection(StationInterface &station, QWidget *parent) : QWidget(parent), m_station(station)
{
    m_on = new QCheckBox(tr("Serve other stations"), this);
    m_on->setObjectName(QStringLiteral("serveOn"));
    m_on->setAccessibleName(m_on->text());
    m_on->setToolTip(
        tr("Lets QGroundControl, Mission Planner, MAVProxy and MAVSDK programs use the sealed link through this window"));
    m_url = new QComboBox(this);
    m_url->setObjectName(QStringLiteral("serveUrl"));
    m_url->setAccessibleName(tr("Address for other stations"));
    m_url->setEditable(true);
    m_url->setInsertPolicy(QComboBox::NoInsert);
    m_url->setToolTip(tr("One address, or several separated by spaces. Each may have options, e.g. "
                         "udpout:127.0.0.1:14540,write=mission,param: write= narrows the rights chosen here. Other "
                         "options: from=ADDRESS/PREFIX, sysid=ID and name=NAME"));
    const auto offer = [this](const QString &url, const QString &use) {
        m_url->addItem(url);
        m_url->setItemData(m_url->count() - 1, use, Qt::ToolTipRole);
    };
    offer(Serving().url, tr("Stations connect to this TCP port"));
    offer(QStringLiteral("udpin:127.0.0.1:14551"), tr("Stations send to this UDP port"));
    offer(QStringLiteral("udpout:127.0.0.1:14540"), tr("A station or a MAVSDK program listens on this UDP port"));
    m_url->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("udpout:255.255.255.255:14550")) + 5 * kGrid);
    m_rights = new QComboBox(this);
    m_rights->setObjectName(QStringLiteral("serveRights"));
    m_rights->setAccessibleName(tr("Rights of other stations"));
    m_rights->addItem(tr("Read only"));
    m_rights->setItemData(0,
                          tr("Telemetry, parameters and missions can be read; commands, changes, files and logs are refused"),
                          Qt::ToolTipRole);
    m_rights->addItem(tr("Read and write"));
    m_rights->setItemData(
        1,
        tr("They can command vehicles, like this station; while they are connected, their heartbeats keep the vehicle's "
           "GCS failsafe from triggering"),
        Qt::ToolTipRole);
    m_classes = new RightsMenu(this);
    m_classesButton = new QToolButton(this);
    m_classesButton->setObjectName(QStringLiteral("serveClasses"));
    m_classesButton->setText(tr("May write"));
    m_classesButton->setAccessibleName(tr("What other stations may write"));
    m_classesButton->setToolTip(tr("What stations may write at the addresses beside, while \"Read and write\" is chosen"));
    m_classesButton->setPopupMode(QToolButton::InstantPopup);
    m_classesButton->setFocusPolicy(Qt::StrongFocus);
    m_classesButton->setMenu(m_classes);
    m_warning = new QLabel(this);
    m_warning->setObjectName(QStringLiteral("serveWarning"));
    m_warning->setAccessibleName(tr("What other stations can do"));
    m_warning->setTextFormat(Qt::PlainText);
    m_warning->setWordWrap(true);
    m_warning->hide();
    m_state = new QLabel(this);
    m_state->setObjectName(QStringLiteral("serveState"));
    m_state->setAccessibleName(tr("State of the gateway"));
    m_state->setTextFormat(Qt::PlainText);
    m_state->setWordWrap(true);
    m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_view = new QTreeView(this);
    m_view->setObjectName(QStringLiteral("serveClients"));
    m_view->setAccessibleName(tr("Connected stations"));
    m_view->setModel(&m_clients);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setFrameShape(QFrame::NoFrame);
    const auto room = [this](const char *sample) { return fontMetrics().horizontalAdvance(QLatin1String(sample)) + 3 * kGrid; };
    m_view->header()->resizeSection(ClientModel::Client, room("255.255.255.255:65535"));
    m_view->header()->resizeSection(ClientModel::Rights, room("reads, writes mission,param"));
    m_view->hide();

    auto *line = new QHBoxLayout;
    line->setSpacing(kGrid);
    line->addWidget(m_on);
    line->addWidget(m_url);
    line->addWidget(m_rights);
    line->addWidget(m_classesButton);
    line->addStretch(1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid);
    column->addLayout(line);
    column->addWidget(m_warning);
    column->addWidget(m_state);
    column->addWidget(m_view, 1);

    connect(m_on, &QCheckBox::toggled, this, &GatewaySection::choose);
    connect(m_url, &QComboBox::activated, this, &GatewaySection::choose);
    connect(m_url->lineEdit(), &QLineEdit::editingFinished, this, &GatewaySection::choose);
    connect(m_rights, &QComboBox::activated, this, &GatewaySection::choose);
    connect(m_classes, &QMenu::aboutToShow, this, [this] {
        const auto first = engine::ServeConfig::parse(addressesIn(m_url->currentText()).front().toStdString(),
                                                      engine::WriteRights::all());
        m_classes->setRights(first ? first->write : engine::WriteRights::all());
    });
    connect(m_classes, &RightsMenu::rightsChosen, this, &GatewaySection::chooseRights);
    m_classes->menuAction()->setObjectName(QStringLiteral("menuServeClasses"));
    m_classes->setTitle(m_classesButton->accessibleName());
    addActions({pressAction(*m_on, Qt::CTRL | Qt::SHIFT | Qt::Key_F2),
                focusAction(*m_url, tr("Change the address for other stations"), Qt::CTRL | Qt::SHIFT | Qt::Key_F3),
                focusAction(*m_rights, tr("Change the rights of other stations"), Qt::CTRL | Qt::SHIFT | Qt::Key_F4),
                m_classes->menuAction()});
    allowClasses(false);
    showState(tr("off"), stateColors(palette()).dim);
}

void GatewaySection::apply(const Serving &serving)
{
    if (serving == m_serving)
        return;
    const QSignalBlocker blocked(m_on);
    m_on->setChecked(serving.on);
    m_url->setEditText(serving.url);
    m_rights->setCurrentIndex(serving.write ? 1 : 0);
    set(serving);
}

void GatewaySection::choose()
{
    const Serving chosen{m_on->isChecked(), m_url->currentText().trimmed(), m_rights->currentIndex() == 1};
    if (chosen == m_serving)
        return;
    set(chosen);
    Q_EMIT servingChanged(m_serving);
}

/// Of all addresses.
void GatewaySection::chooseRights(const engine::WriteRights &rights)
{
    QStringList addresses = addressesIn(m_url->currentText());
    for (QString &address : addresses)
        address = withRights(address, rights);
    m_url->setEditText(addresses.join(QLatin1Char(' ')));
    choose();
}

/// In the panel and in the command palette.
void GatewaySection::allowClasses(bool allowed)
{
    m_classesButton->setEnabled(allowed);
    m_classes->menuAction()->setEnabled(allowed);
    m_classes->menuAction()->setStatusTip(allowed ? QString() : tr("\"Read and write\" is not chosen"));
}

void GatewaySection::set(const Serving &serving)
{
    allowClasses(serving.write);
    const bool changesService = serving.on || m_serving.on;
    m_serving = serving;
    if (changesService)
        serve();
    showRights();
}

void GatewaySection::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_view)
        showRights();
}

void GatewaySection::showRights()
{
    const QStringList classes = m_serving.write ? writtenAt(m_serving.url) : QStringList();
    const QString consequence = consequenceOf(classes);
    m_warning->setVisible(!consequence.isEmpty());
    m_warning->setText(QStringLiteral("▲ ") + consequence);
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, stateColors(colors).warning);
    m_warning->setPalette(colors);
    const bool shared = m_isServing && !consequence.isEmpty();
    const QString word = mayCommand(classes) ? tr("Others may command") : tr("Others may write");
    Q_EMIT sharingChanged(shared ? word : QString(), shared ? consequence : QString());
}

void GatewaySection::serve()
{
    const StateColors &colors = stateColors(palette());
    m_clients.setClients({});
    m_view->hide();
    m_open = m_isServing = false;
    if (!m_serving.on) {
        m_station.serve({});
        showState(tr("off"), colors.dim);
        return;
    }
    std::vector<engine::ServeConfig> configs;
    for (const QString &address : addressesIn(m_serving.url)) {
        // Rights that the address names (write=mission) narrow the choice and never widen it.
        auto config = engine::ServeConfig::parse(address.toStdString(), engine::WriteRights::all());
        if (!config) {
            m_station.serve({});
            showState(tr("%1: %2").arg(address, reasonText(config.error())), colors.alarm);
            return;
        }
        if (!m_serving.write)
            config->write = {};
        m_open = m_open || config->isOpenToOthers();
        configs.push_back(std::move(*config));
    }
    m_isServing = true;
    showState(engine::linkPhaseText(engine::LinkPhase::Opening), colors.dim);
    m_station.serve(std::move(configs));
}

void GatewaySection::showSnapshot(const engine::Snapshot &snapshot)
{
    // A snapshot made before the service was changed may still come: the next one follows within a second.
    if (!m_serving.on || snapshot.served.empty())
        return;
    const StateColors &colors = stateColors(palette());
    const engine::LinkSnapshot &link = worstOf(snapshot.served);
    QString phase = engine::linkPhaseText(link.phase);
    if (snapshot.served.size() > 1 && !link.problem.empty())
        phase = tr("%1: %2").arg(fromStd(link.url), phase);
    if (!link.problem.empty())
        showState(tr("%1: %2").arg(phase, reasonText(link.problem)), colors.alarm);
    else if (m_open)
        showState(tr("%1, open to other computers; %2").arg(phase, served(snapshot.clients.size())), colors.warning);
    else
        showState(tr("%1; %2").arg(phase, served(snapshot.clients.size())), palette().color(QPalette::WindowText));
    m_clients.setClients(snapshot.clients);
    m_view->setVisible(!snapshot.clients.empty());
}

void GatewaySection::showState(const QString &text, const QColor &color)
{
    m_state->setText(text);
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, color);
    m_state->setPalette(colors);
}

} // namespace skyseal::ui

#include "moc_gateway_section.cpp"
