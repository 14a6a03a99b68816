#include "ui/window/source_bar.h"

#include "core/engine/station/snapshot.h"
#include "ui/control_action.h"
#include "ui/replay/replay_bar.h"
#include "ui/text/lock_face.h"
#include "ui/text/plain_tip.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"

#include <QtCore/QEvent>
#include <QtGui/QGuiApplication>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include <algorithm>
#include <utility>

namespace skyseal::ui {

namespace {

const QColor kGround(0xf2, 0xc1, 0x00), kInk(0x10, 0x10, 0x10), kAlarm(0xa8, 0x00, 0x10); // the same in every theme

} // namespace

SourceBar::SourceBar(QWidget *parent) : QFrame(parent), m_replay(new ReplayBar(parent))
{
    setObjectName(QStringLiteral("sourceBar"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window); // not that of the tool bar
    m_title = new QLabel(this);
    m_title->setObjectName(QStringLiteral("sourceTitle"));
    m_title->setTextFormat(Qt::PlainText);
    QFont strong = font();
    strong.setBold(true);
    m_title->setFont(strong);
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_state = new QLabel(this);
    m_state->setObjectName(QStringLiteral("sourceLive"));
    m_state->setTextFormat(Qt::PlainText);
    m_end = new QPushButton(this);
    m_end->setObjectName(QStringLiteral("sourceEnd"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(2 * kGrid, kHalfGrid, kGrid, kHalfGrid);
    row->setSpacing(2 * kGrid);
    row->addWidget(m_title, 1);
    row->addWidget(m_state);
    row->addWidget(m_end);

    connect(m_end, &QPushButton::clicked, this, &SourceBar::endRequested);
    showSource(Source::Live);
    addActions({pressAction(*m_end, Qt::SHIFT | Qt::Key_F12)});
    addActions(m_replay->actions());
}

void SourceBar::showSource(Source source, const QString &name)
{
    m_source = source;
    m_name = name;
    setState({}, false);
    const bool demo = source == Source::Demo;
    m_title->setText(demo ? tr("DEMO: a simulated copter takes off and flies by itself until you command it")
                          : tr("REPLAY: %1").arg(name));
    m_title->setToolTip(
        demo ? tr("All data are simulated. Your first command ends the flight of the demo. End the demo, here or in "
                  "the menu Tools, returns to your links.")
             : plainTip(m_title->text()));
    m_end->setText(demo ? tr("End the demo") : tr("Back to live"));
    m_end->setAccessibleName(m_end->text());
    paintSource();
    setVisible(source != Source::Live);
    m_replay->startOver();
    m_replay->setEnabled(true);
    m_replay->setVisible(source == Source::Replay);
}

void SourceBar::showReplay(const ViewState &replay)
{
    if (replay.snapshot->replay)
        m_replay->showStatus(*replay.snapshot->replay);
    const auto &links = replay.snapshot->links;
    const bool over = !links.empty() && std::ranges::all_of(links, [](const engine::LinkSnapshot &link) {
        return link.phase == engine::LinkPhase::Finished || link.phase == engine::LinkPhase::Closed;
    });
    const auto failed = std::ranges::find(links, engine::LinkPhase::Failed, &engine::LinkSnapshot::phase);
    m_replay->setEnabled(failed == links.end());
    const QString title = failed != links.end() ? tr("REPLAY: %1 · %2").arg(m_name, reasonText(failed->problem))
        : over                                  ? tr("REPLAY: %1 · finished").arg(m_name)
                                                : tr("REPLAY: %1").arg(m_name);
    if (m_title->text() == title)
        return;
    m_title->setText(title);
    m_title->setToolTip(plainTip(title));
}

void SourceBar::showLive(const ViewState &live)
{
    const LockFace lock = lockFaceOf(live);
    QStringList parts;
    bool alarm = lock.lost || lock.security == engine::Security::UnderAttack;
    if (live.vehicle) {
        const auto &state = live.vehicle->state;
        parts << tr("Live: vehicle %1").arg(state.systemId) << (state.armed ? tr("ARMED") : tr("disarmed"));
        if (live.stale()) {
            alarm = true;
            parts << tr("lost for %1").arg(durationText(state.messageAge));
        }
    } else {
        parts << tr("Live: no vehicle");
    }
    if (!lock.variants.isEmpty())
        parts << lock.variants.last();
    setState(parts.join(QStringLiteral(" · ")), alarm);
}

void SourceBar::setState(const QString &text, bool alarm)
{
    const QString shown = alarm ? QStringLiteral("▲ ") + text : text;
    if (m_state->text() != shown)
        m_state->setText(shown);
    if (std::exchange(m_alarm, alarm) != alarm)
        paintSource();
}

void SourceBar::paintSource()
{
    QPalette colors = QGuiApplication::palette();
    m_end->setPalette(colors);
    colors.setColor(QPalette::Window, kGround);
    colors.setColor(QPalette::WindowText, kInk);
    setPalette(colors);
    m_title->setPalette(colors);
    colors.setColor(QPalette::WindowText, m_alarm ? kAlarm : kInk);
    m_state->setPalette(colors);
}

void SourceBar::changeEvent(QEvent *event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::ApplicationPaletteChange)
        paintSource();
}

} // namespace skyseal::ui

#include "moc_source_bar.cpp"
