#include "ui/map/empty_state.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/state_text.h"
#include "ui/security/allow_plain.h"
#include "ui/text/command_permits.h"
#include "ui/text/link_ended.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/instrument_style.h"

#include <QtGui/QFontDatabase>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

EmptyState::EmptyState(QWidget *parent) : QScrollArea(parent)
{
    setObjectName(QStringLiteral("emptyState"));
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidgetResizable(true);
    auto *page = new QWidget(this);
    setWidget(page);
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(3 * kGrid, 3 * kGrid, 3 * kGrid, 3 * kGrid);
    column->setSpacing(kGrid);
    m_title = new QLabel(page);
    m_title->setObjectName(QStringLiteral("emptyTitle"));
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() + 3);
    large.setWeight(QFont::DemiBold);
    m_title->setFont(large);
    m_title->setWordWrap(true);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Maximum);
    m_text = new QLabel(page);
    m_text->setObjectName(QStringLiteral("emptyText"));
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_command = new QLabel(page);
    m_command->setObjectName(QStringLiteral("emptyCommand"));
    m_command->setAccessibleName(tr("Command to run beside the autopilot"));
    m_command->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_command->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_otherwise = new QLabel(tr("or let any autopilot send plain MAVLink here: it is shown, but not sealed."), page);
    m_otherwise->setWordWrap(true);
    m_demo = new QPushButton(tr("Start the demo"), page);
    m_demo->setObjectName(QStringLiteral("demoButton"));
    m_demo->setAccessibleName(m_demo->text());
    m_demo->hide();
    m_connect = new QPushButton(tr("Add a link…"), page);
    m_connect->setObjectName(QStringLiteral("connectButton"));
    m_connect->setAccessibleName(m_connect->text());
    m_plain = new QPushButton(page);
    m_plain->setObjectName(QStringLiteral("allowPlainButton"));
    m_plain->setAccessibleName(tr("Allow plain MAVLink"));
    m_plain->hide();
    m_keys = new QPushButton(tr("Keys and peers…"), page);
    m_keys->setObjectName(QStringLiteral("emptyKeys"));
    m_keys->setAccessibleName(tr("Open keys and peers"));
    m_keys->hide();
    column->addWidget(m_title);
    column->addWidget(m_text);
    column->addWidget(m_command);
    column->addWidget(m_otherwise);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(kGrid);
    buttons->addWidget(m_demo);
    buttons->addWidget(m_connect);
    buttons->addStretch(1);
    column->addSpacing(kGrid);
    column->addWidget(m_plain, 0, Qt::AlignLeft);
    column->addWidget(m_keys, 0, Qt::AlignLeft);
    column->addLayout(buttons);
    connect(m_plain, &QPushButton::clicked, this, [this] { Q_EMIT plainRequested(m_held); });
    connect(m_keys, &QPushButton::clicked, this, &EmptyState::keysRequested);
    connect(m_demo, &QPushButton::clicked, this, &EmptyState::demoRequested);
    connect(m_connect, &QPushButton::clicked, this, &EmptyState::connectRequested);
    showViewState({});
}

QSize EmptyState::sizeHint() const
{
    constexpr int kWidth = 54 * kGrid;
    return {kWidth, widget()->layout()->heightForWidth(kWidth)};
}

QSize EmptyState::minimumSizeHint() const
{
    constexpr int kLeastHeight = 18 * kGrid;
    const QSize whole = sizeHint();
    return leastTarget(*this) == 0 ? whole : whole.boundedTo({whole.width(), kLeastHeight});
}

void EmptyState::setDemoAvailable(bool available)
{
    m_demo->setVisible(available);
}

void EmptyState::showViewState(const ViewState &view)
{
    setVisible(!view.vehicle);
    if (view.vehicle)
        return;
    QString listening;
    bool replaying = false;
    if (view.snapshot) {
        for (const auto &link : view.snapshot->links) {
            if (link.phase == engine::LinkPhase::Failed)
                continue;
            replaying |= link.recording;
            if (listening.isEmpty())
                listening = fromStd(link.localAddress.empty() ? link.url : link.localAddress);
        }
    }
    QString title, text, command;
    const engine::UnknownAgent *unknown = unknownAgentOf(view);
    if (view.key.isOpening) {
        title = tr("Opening this station's key…");
        text = tr("Its passphrase is being checked. Sealed links can start after that.");
    } else if (!view.key.problem.isEmpty()) {
        title = tr("This station cannot use its key");
        text =
            tr("%1\n\nNo link is sealed until this is resolved. Plain MAVLink is shown, but not sealed.").arg(view.key.problem);
    } else if (view.session) {
        title = tr("Waiting for the autopilot behind %1").arg(fromStd(view.session->info.peerName));
        text = tr("The link to the agent is sealed; nothing has been received from its vehicle yet.");
    } else if (view.pendingApproval) {
        m_held = *view.pendingApproval;
        title = tr("Vehicle %1 is not sealed").arg(m_held.systemId);
        text = tr("It sends plain MAVLink from %1 and may be impersonating %2, which is a known peer but has not "
                  "been heard yet. Its telemetry is not shown and nothing is sent to it until you allow plain "
                  "MAVLink.\n\nIf it is the vehicle of %2, start the agent beside it instead, so that its link is "
                  "sealed.")
                   .arg(fromStd(m_held.remoteAddress), engine::anyOfNames(m_held.mayBe));
    } else if (view.snapshot && !view.snapshot->unanswering.empty()) {
        const engine::UnansweringAgent &agent = view.snapshot->unanswering.front();
        title = tr("The agent %1 does not answer").arg(fromStd(agent.peerName));
        text = tr("It is reachable at %1, but it does not answer the handshake. Does it know this station's "
                  "key?\n\nIts list of peers must contain the key with the fingerprint\n%2\n\nIt also does "
                  "not answer if it permits none of the suites that this station offers.")
                   .arg(fromStd(agent.remoteAddress), fromStd(agent.ownFingerprint));
    } else if (unknown) {
        title = tr("An unknown agent");
        text = tr("It announces itself from %1 with a key that is not in this station's list of peers. An "
                  "announcement does not contain the fingerprint.\n\nIf the agent is yours, pair the two: choose "
                  "Pair in Keys and peers here and, while the vehicle is disarmed, run beside the agent:")
                   .arg(fromStd(unknown->remoteAddress));
        command = QStringLiteral("skyseal-air --pair --identity air.key");
    } else if (replaying) {
        title = tr("Replaying a log");
        text = tr("No vehicle in the log so far.");
    } else if (listening.isEmpty()) {
        title = tr("Nothing is connected");
        text = tr("Add a link to the vehicle, or listen for one on UDP port 14550.");
    } else {
        title = tr("Waiting for a vehicle on %1").arg(listening);
        text = tr(
            "Start an agent, skyseal-air, beside an autopilot. If it has no key yet, the first line creates one; then pair "
            "the two in Security → Keys and peers:");
        // The port that is open, which may differ from the settings.
        command = QStringLiteral("skyseal-cli keys new --out air.key\n"
                                 "skyseal-air --vehicle tcp:127.0.0.1:5760 \\\n"
                                 "  --ground udpout:127.0.0.1:%1 \\\n"
                                 "  --identity air.key --peers air.peers")
                      .arg(listening.section(QLatin1Char(':'), -1));
    }
    const bool held = view.pendingApproval && !view.session;
    m_plain->setVisible(held);
    if (held && m_plain->text() != allowPlainText(m_held)) {
        m_plain->setText(allowPlainText(m_held));
        m_plain->setAccessibleName(m_plain->text());
    }
    const QString noDemo = demoDisabledReason(view);
    m_demo->setEnabled(noDemo.isEmpty());
    m_demo->setToolTip(noDemo);
    m_command->setVisible(!command.isEmpty());
    m_otherwise->setVisible(!command.isEmpty() && !unknown);
    m_keys->setVisible(unknown || (!view.key.problem.isEmpty() && !view.key.isOpening));
    if (m_command->text() != command)
        m_command->setText(command);
    if (m_title->text() != title)
        m_title->setText(title);
    if (m_text->text() != text)
        m_text->setText(text);
    updateGeometry();
}

} // namespace skyseal::ui

#include "moc_empty_state.cpp"
