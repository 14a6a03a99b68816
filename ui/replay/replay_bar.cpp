#include "ui/replay/replay_bar.h"

#include "core/log/log_index.h"
#include "ui/control_action.h"
#include "ui/replay/link_event_text.h"
#include "ui/replay/replay_timeline.h"
#include "ui/text/figures.h"
#include "ui/text/units.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"
#include "ui/theme/icons.h"

#include <QtCore/QDateTime>
#include <QtCore/QLocale>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QPushButton>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr int kReplayStep = 10'000; ///< milliseconds
constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50};

QString speedText(double speed)
{
    return QStringLiteral("%1 ×").arg(withDecimalPoint(QString::number(speed)));
}

} // namespace

ReplayBar::ReplayBar(QWidget *parent)
    : QFrame(parent), m_play(new QPushButton(this)), m_speed(new QComboBox(this)), m_line(new ReplayTimeline(this)),
      m_position(new FigureLabel(this))
{
    setObjectName(QStringLiteral("replayBar"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window);
    m_play->setObjectName(QStringLiteral("replayPlay"));
    m_play->setAutoDefault(false);
    showPlaying(false);
    const int paused = m_play->sizeHint().width();
    showPlaying(true);
    m_play->setFixedWidth(std::max(paused, m_play->sizeHint().width()));
    named(m_speed, "replaySpeed", tr("Speed of the replay"));
    m_speed->setToolTip(m_speed->accessibleName());
    for (const double speed : kSpeeds)
        m_speed->addItem(speedText(speed), speed);
    m_line->setObjectName(QStringLiteral("replayLine"));
    named(m_position, "replayPosition", tr("Position and length of the replay"));

    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(kGrid, kHalfGrid, 2 * kGrid, kHalfGrid);
    row->setSpacing(kGrid);
    row->addWidget(m_play);
    row->addWidget(m_speed);
    row->addWidget(m_line, 1);
    row->addWidget(m_position);

    connect(m_play, &QPushButton::clicked, this, &ReplayBar::playOrPause);
    connect(m_speed, &QComboBox::activated, this, &ReplayBar::chooseSpeed);
    connect(m_line, &ReplayTimeline::seekRequested, this, &ReplayBar::seek);
    makeActions();
    startOver();
}

void ReplayBar::makeActions()
{
    const auto onLine = [this](const char *id, const QString &text, Qt::Key key, std::function<void()> act) {
        return new ControlAction(*m_line, QLatin1String(id), text, Qt::SHIFT | key, std::move(act));
    };
    const auto onSpeed = [this](const char *id, const QString &text, Qt::Key key, int steps) {
        return new ControlAction(*m_speed, QLatin1String(id), text, Qt::SHIFT | key, [this, steps] { stepSpeed(steps); });
    };
    const auto skip = [this](int milliseconds) {
        return [this, milliseconds] { m_line->seekTo(m_line->value() + milliseconds); };
    };
    addActions({pressAction(*m_play, Qt::SHIFT | Qt::Key_F3),
                onLine("replayBack", tr("Back 10 s"), Qt::Key_F2, skip(-kReplayStep)),
                onLine("replayForward", tr("Forward 10 s"), Qt::Key_F4, skip(kReplayStep)),
                onSpeed("replaySlower", tr("Slower"), Qt::Key_F6, -1), onSpeed("replayFaster", tr("Faster"), Qt::Key_F7, 1),
                onLine("replayPreviousEvent", tr("Previous event"), Qt::Key_F8, [this] { m_line->goToMark(false); }),
                onLine("replayNextEvent", tr("Next event"), Qt::Key_F9, [this] { m_line->goToMark(true); })});
}

void ReplayBar::stepSpeed(int steps)
{
    const int index = std::clamp(m_speed->currentIndex() + steps, 0, m_speed->count() - 1);
    if (index == m_speed->currentIndex())
        return;
    m_speed->setCurrentIndex(index);
    chooseSpeed(index);
}

void ReplayBar::chooseSpeed(int index)
{
    Q_EMIT commandRequested(engine::SetReplaySpeed{m_speed->itemData(index).toDouble()});
}

void ReplayBar::startOver()
{
    m_requested = 0;
    engine::ReplayStatus begins;
    begins.playing = true;
    m_speed->setCurrentIndex(m_speed->findData(begins.speed));
    showStatus(begins);
}

void ReplayBar::showStatus(const engine::ReplayStatus &status)
{
    showPlaying(status.playing);
    if (m_status.speed != status.speed)
        m_speed->setCurrentIndex(m_speed->findData(status.speed));
    if (m_status.index != status.index || m_position->value().isEmpty()) {
        m_line->setIndex(status.index);
        const QString sample = status.index ? durationText(seconds(status.index->length)) : QStringLiteral("88:88");
        m_position->setSample(sample, QStringLiteral("/ ") + sample);
    }
    m_status = status;
    if (status.seeks >= m_requested)
        showPosition();
}

void ReplayBar::showPlaying(bool playing)
{
    const QString text = playing ? tr("Pause") : tr("Play");
    if (m_play->text() == text)
        return;
    m_play->setText(text);
    m_play->setIcon(icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
    m_play->setAccessibleName(playing ? tr("Pause the replay") : tr("Play the replay"));
    m_play->setToolTip(tr("%1 (Space, while the focus is in this bar)").arg(m_play->accessibleName()));
}

void ReplayBar::showPosition()
{
    m_line->showPosition(m_status.position);
    const QString length = m_status.index ? durationText(seconds(m_status.index->length)) : dash();
    m_position->setFigure(durationText(seconds(m_status.position)), QStringLiteral("/ ") + length);
    QString tip = m_position->accessibleName();
    if (m_status.time) {
        const auto since = std::chrono::floor<std::chrono::seconds>(m_status.time->time_since_epoch());
        const QDateTime time = QDateTime::fromSecsSinceEpoch(since.count());
        tip += QLatin1Char('\n') + tr("Recorded %1").arg(QLocale().toString(time, QStringLiteral("yyyy-MM-dd HH:mm:ss")));
    }
    if (m_status.index && m_status.index->unreadableEvents > 0)
        tip += QLatin1Char('\n') + tr("Beside the recording: %1").arg(unreadableEventsText(*m_status.index));
    if (m_position->toolTip() != tip)
        m_position->setToolTip(tip);
}

/// At the end it plays from the beginning.
void ReplayBar::playOrPause()
{
    if (m_status.playing) {
        Q_EMIT commandRequested(engine::PauseReplay{});
        return;
    }
    if (m_status.ended)
        seek(Duration::zero());
    Q_EMIT commandRequested(engine::PlayReplay{});
}

void ReplayBar::seek(Duration to)
{
    m_requested = std::max(m_requested, m_status.seeks) + 1;
    Q_EMIT commandRequested(engine::SeekReplay{to});
}

void ReplayBar::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
        playOrPause();
    else
        QFrame::keyPressEvent(event);
}

} // namespace skyseal::ui

#include "moc_replay_bar.cpp"
