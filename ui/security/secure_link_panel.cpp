#include "ui/security/secure_link_panel.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/event_text.h"
#include "core/engine/text/system_text.h"
#include "ui/security/counters_table.h"
#include "ui/security/suite_actions.h"
#include "ui/security/suite_row.h"
#include "ui/text/command_age.h"
#include "ui/text/link_ended.h"
#include "ui/text/lock_face.h"
#include "ui/text/one_way.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/icons.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QComboBox>
#include <QtWidgets/QFrame>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

using engine::Security;

namespace {

void put(QLabel *label, const QString &text)
{
    if (label->text() != text)
        label->setText(text);
    label->setVisible(!text.isEmpty());
}

constexpr int kLeastFit = 4;

} // namespace

SecureLinkPanel::SecureLinkPanel(SuiteActions &suites, QWidget *parent) : DockPanel(parent), m_suites(suites)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
    column->setSpacing(kHalfGrid);

    auto *head = new QHBoxLayout;
    head->setSpacing(kGrid);
    m_icon = new QLabel(this);
    m_icon->setFixedSize(24, 24);
    m_title = new QLabel(this);
    m_title->setObjectName(QStringLiteral("secureTitle"));
    m_title->setWordWrap(true);
    QFont strong = font();
    strong.setWeight(QFont::DemiBold);
    m_title->setFont(strong);
    head->addWidget(m_icon);
    head->addWidget(m_title, 1);
    column->addLayout(head);

    m_sessions = new QComboBox(this);
    m_sessions->setObjectName(QStringLiteral("sessionBox"));
    m_sessions->setAccessibleName(tr("Session to show"));
    m_sessions->hide();
    connect(m_sessions, &QComboBox::activated, this, [this] { Q_EMIT sessionChosen(m_sessions->currentData().toUInt()); });
    column->addWidget(m_sessions);

    const auto fact = [&](const char *objectName, const QString &accessible) {
        auto *label = new QLabel(this);
        label->setObjectName(QLatin1String(objectName));
        label->setAccessibleName(accessible);
        label->setForegroundRole(QPalette::PlaceholderText);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        column->addWidget(label);
        return label;
    };
    m_peer = fact("securePeer", tr("Peer"));
    m_since = fact("secureSince", tr("Sealed since"));

    m_advice = new QLabel(this);
    m_advice->setObjectName(QStringLiteral("secureAdvice"));
    m_advice->setWordWrap(true);
    column->addWidget(m_advice);
    m_help = new QPushButton(tr("How to seal this link"), this);
    m_help->setObjectName(QStringLiteral("secureHelp"));
    m_help->setAccessibleName(m_help->text());
    connect(m_help, &QPushButton::clicked, this, [this] { Q_EMIT helpRequested(QStringLiteral("sealing")); });
    column->addWidget(m_help, 0, Qt::AlignLeft);
    m_keys = new QPushButton(tr("Keys and peers…"), this);
    m_keys->setObjectName(QStringLiteral("secureKeys"));
    m_keys->setAccessibleName(tr("Open keys and peers"));
    m_keys->hide();
    connect(m_keys, &QPushButton::clicked, this, &SecureLinkPanel::keysRequested);
    column->addWidget(m_keys, 0, Qt::AlignLeft);

    column->addSpacing(kHalfGrid);
    for (QAction *action : suites.actions())
        column->addWidget(new SuiteRow(*action, this));
    m_note = new QLabel(this);
    m_note->setObjectName(QStringLiteral("switchNote"));
    m_note->setAccessibleName(tr("Result of the last switch"));
    m_note->setWordWrap(true);
    m_note->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_note->setMinimumHeight(2 * fontMetrics().lineSpacing());
    column->addWidget(m_note);
    m_line = new QFrame(this);
    m_line->setFrameShape(QFrame::HLine);
    m_line->setForegroundRole(QPalette::Mid);
    m_line->setFrameShadow(QFrame::Plain);
    column->addWidget(m_line);
    m_counters = new CountersTable(this);
    column->addWidget(m_counters);
    setMinimumWidth(m_counters->minimumSizeHint().width() + 2 * kGrid); // also while there are no counters to show
    column->addSpacing(kHalfGrid);
    m_fingerprint = fact("secureFingerprint", tr("Fingerprint of the peer's key"));
    m_fingerprint->setWordWrap(true);
    column->addStretch(1);

    connect(&suites, &SuiteActions::noteChanged, this, &SecureLinkPanel::showNote);
    showViewState({});
    applyFit(0);
}

void SecureLinkPanel::showViewState(const ViewState &view)
{
    m_sealed = view.session != nullptr;
    showHead(view);
    showSessions(view);
    m_counters->showStats(view.session ? &view.session->stats : nullptr);
    arrange();
}

void SecureLinkPanel::fitHeight(int height)
{
    if (height != m_room) {
        m_room = height;
        arrange();
    }
}

void SecureLinkPanel::applyFit(int level)
{
    m_level = level;
    m_fingerprint->setVisible(m_sealed && level < 1);
    m_counters->setBrief(level >= 2);
    m_since->setVisible(m_sealed && level < 4);
    m_note->setMinimumHeight((level >= 3 ? 1 : 2) * fontMetrics().lineSpacing());
    // Without a session there are no counters; the advice takes their place.
    m_counters->setVisible(m_sealed);
    m_line->setVisible(m_sealed);
}

void SecureLinkPanel::arrange()
{
    if (m_sealed != m_counters->isVisibleTo(this))
        applyFit(m_level);
    // The fullest level that fits, computed from the current one, so that no widget changes only to be measured.
    const auto saving = [this](int level) { // only what is needed is measured: a wrapped text is laid out for it
        switch (level) {
        case 0: return m_sealed ? m_fingerprint->heightForWidth(width() - 2 * kGrid) + layout()->spacing() : 0;
        case 1: return m_sealed ? 4 * m_counters->rowHeight() : 0;
        case 2: return fontMetrics().lineSpacing();
        default: return m_sealed ? m_since->sizeHint().height() + layout()->spacing() : 0;
        }
    };
    int needed = layout()->totalHeightForWidth(width());
    for (int i = 0; i < m_level; ++i)
        needed += saving(i);
    int level = 0;
    while (m_room > 0 && level < kLeastFit && needed > m_room)
        needed -= saving(level++);
    if (level != m_level)
        applyFit(level);
}

void SecureLinkPanel::showHead(const ViewState &view)
{
    const StateColors &colors = stateColors(palette());
    const LockFace face = lockFaceOf(view);
    const auto oneWay = oneWayOf(view);
    const engine::UnknownAgent *unknown = unknownAgentOf(view);
    QString title, advice;
    QColor color = colors.dim;
    switch (face.security) {
    case Security::Nothing:
        title = tr("No sealed link");
        advice = tr("The session starts automatically when a known agent announces itself.");
        if (view.key.isOpening) {
            title = tr("Opening the key…");
            advice = tr("The passphrase of this station's key is being checked. Sealed links can start after that.");
        } else if (!view.key.problem.isEmpty()) {
            title = tr("No sealed links");
            advice = tr("This station cannot use its key: %1").arg(view.key.problem);
        } else if (oneWay) {
            title = oneWay->title;
            advice = oneWay->advice;
        } else if (const engine::UnansweringAgent *agent = unansweringOf(view)) {
            title = tr("%1 does not answer").arg(fromStd(agent->peerName));
            advice = face.toolTip;
        } else if (unknown) {
            advice = tr("%1. If it is yours, pair the two.").arg(engine::unknownAgentText(fromStd(unknown->remoteAddress)));
        } else if (const auto ended = linkEndedOf(view)) {
            title = ended->title;
            advice = ended->advice;
        }
        if (face.lost)
            color = colors.warning;
        break;
    case Security::Plain:
        title = tr("Not sealed");
        advice = face.toolTip;
        if (view.pendingApproval) {
            title = tr("Not sealed, needs approval");
        } else if (oneWay) {
            title = oneWay->title;
            advice = oneWay->advice;
        } else if (!view.key.problem.isEmpty() && !view.key.isOpening) {
            advice =
                tr("Anyone on the path can read and change the traffic. This station cannot seal the link, because it cannot "
                   "use its key: %1")
                    .arg(view.key.problem);
        } else if (view.plainRun) {
            title = tr("Not sealed, sweep running");
        }
        color = colors.warning;
        break;
    case Security::Sealed:
        title = tr("Sealed");
        color = colors.good;
        if (view.session && view.session->info.silent) {
            title = tr("Sealed, no data received");
            advice = tr("It continues automatically when the agent is heard again.");
            color = colors.warning;
        } else if (const auto age = commandAgeOf(view); age && age->late) {
            title = age->ignored ? tr("Sealed, commands are ignored") : tr("Sealed, commands are late");
            advice = tr("%1. %2.").arg(age->sentence, age->limits);
            color = colors.warning;
        } else if (view.session && view.session->stats.peerCannotStore) {
            title = tr("Sealed, disk error at the agent");
            advice = tr("%1.").arg(engine::peerCannotStoreText(fromStd(view.session->info.peerName)));
            color = colors.warning;
        } else if (!view.snapshot->storageProblem.empty()) {
            title = tr("Sealed, disk error on this computer");
            advice = tr("%1.").arg(engine::countersNotStoredText(view.snapshot->storageProblem));
            color = colors.warning;
        }
        break;
    case Security::Switching:
        title = view.session && view.session->info.pending == view.session->info.suite ? tr("Sealed, changing keys…")
                                                                                       : tr("Sealed, switching…");
        color = colors.good;
        break;
    case Security::UnderAttack:
        title = tr("Under attack, all refused");
        if (view.session)
            advice = tr("%1 forged, %2 replayed in this session")
                         .arg(grouped(view.session->stats.rx.forged), grouped(view.session->stats.rx.replayed));
        if (view.refusedLastMinute > 0)
            advice += QLatin1Char('\n') + tr("%1 spoofed frames in this session").arg(grouped(view.refused));
        color = colors.alarm;
        break;
    }
    put(m_title, title);
    put(m_advice, advice);
    const bool keyUnusable = !view.session && (view.key.isOpening || !view.key.problem.isEmpty());
    m_help->setVisible(!view.session && !face.lost && !view.plainRun && !oneWay && !keyUnusable);
    m_keys->setVisible((face.lost || unknown || (keyUnusable && !view.key.isOpening)) && !view.inSweep);
    const QPixmap picture = iconPixmap(face.icon, 24, color, devicePixelRatioF());
    if (m_icon->pixmap(Qt::ReturnByValue).cacheKey() != picture.cacheKey())
        m_icon->setPixmap(picture);
    QPalette titleColors = palette();
    if (face.security == Security::UnderAttack || face.security == Security::Plain || face.lost)
        titleColors.setColor(QPalette::WindowText, color);
    if (m_title->palette().color(QPalette::WindowText) != titleColors.color(QPalette::WindowText))
        m_title->setPalette(titleColors);

    if (!view.session) {
        put(m_peer, {});
        return;
    }
    const auto &info = view.session->info;
    const QString name = info.peerName.empty() ? tr("unnamed peer") : fromStd(info.peerName);
    put(m_peer, tr("%1 ✓ · %2").arg(name, fromStd(view.session->remoteAddress)));
    m_since->setText(tr("epoch %1 · for %2").arg(static_cast<quint32>(info.epoch)).arg(durationText(view.session->age)));
    const QString fingerprint = tr("Fingerprint of %1\n%2").arg(name, fromStd(view.session->fingerprint));
    if (m_fingerprint->text() != fingerprint)
        m_fingerprint->setText(fingerprint);
    const auto age = commandAgeOf(view);
    m_since->setToolTip(age ? age->sentence + QLatin1Char('\n') + age->limits : QString());
    QStringList tip{m_since->text(), fingerprint};
    for (const engine::OtherSystemsHeard &heard : view.snapshot->otherSystems) {
        if (heard.peer == info.peerName)
            tip << engine::otherSystemsText(heard);
    }
    m_peer->setToolTip(tip.join(QLatin1Char('\n')));
}

void SecureLinkPanel::showSessions(const ViewState &view)
{
    const std::size_t count = view.snapshot ? view.snapshot->sessions.size() : 0;
    m_sessions->setVisible(count > 1);
    if (count <= 1)
        return;
    if (static_cast<std::size_t>(m_sessions->count()) != count) {
        m_sessions->clear();
        for (const auto &session : view.snapshot->sessions)
            m_sessions->addItem({}, static_cast<quint32>(session.info.session));
    }
    for (int i = 0; i < m_sessions->count(); ++i) {
        const auto &session = view.snapshot->sessions[static_cast<std::size_t>(i)];
        const QString text = tr("%1 · %2").arg(fromStd(session.info.peerName), suiteName(session.info.suite));
        if (m_sessions->itemText(i) != text)
            m_sessions->setItemText(i, text);
        m_sessions->setItemData(i, static_cast<quint32>(session.info.session));
        if (view.session == &session && m_sessions->currentIndex() != i && !m_sessions->view())
            m_sessions->setCurrentIndex(i);
    }
}

void SecureLinkPanel::showNote()
{
    put(m_note, m_suites.note());
    m_note->show();
    QPalette colors = palette();
    if (m_suites.noteIsProblem())
        colors.setColor(QPalette::WindowText, stateColors(palette()).warning);
    m_note->setPalette(colors);
}

} // namespace skyseal::ui

#include "moc_secure_link_panel.cpp"
