#include "ui/flight/emergency_stop.h"

#include "ui/command_guard.h"
#include "ui/control_action.h"
#include "ui/text/vehicle_name.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QCheckBox>

#include <algorithm>

namespace skyseal::ui {

EmergencyStop::EmergencyStop(QWidget *parent)
    : QWidget(parent), m_box(new QBoxLayout(QBoxLayout::LeftToRight, this)), m_unlock(new QCheckBox(tr("Unlock"), this)),
      m_stop(new HoldButton(tr("Emergency stop"), this, kStopHoldMs))
{
    m_unlock->setObjectName(QStringLiteral("unlockStop"));
    m_unlock->setAccessibleName(tr("Unlock the emergency stop"));
    new CommandGuard(*m_unlock);
    m_stop->setObjectName(QStringLiteral("emergencyStopButton"));
    m_stop->setPurpose(tr("Stops the motors at once. A vehicle in the air falls. Hold for one second."));
    m_box->setContentsMargins(0, 0, 0, 0);
    m_box->setSpacing(kHalfGrid);
    m_box->addWidget(m_unlock);
    m_box->addWidget(m_stop);
    m_relock.setObjectName(QStringLiteral("relock"));
    m_relock.setSingleShot(true);
    connect(&m_relock, &QTimer::timeout, this, [this] {
        if (m_stop->isHeld())
            m_relock.start(kStopHoldMs);
        else
            lock();
    });
    connect(m_unlock, &QCheckBox::toggled, this, [this](bool unlocked) {
        if (unlocked)
            m_relock.start(kUnlockedMs);
        showLock();
    });
    connect(m_stop, &HoldButton::confirmed, this, [this] {
        lock();
        Q_EMIT confirmed();
    });
    // No key and no entry of a list fires it: they lead to its lock.
    addAction(focusAction(*m_unlock, tr("Go to the lock of the emergency stop"), Qt::CTRL | Qt::SHIFT | Qt::Key_E));
    showLock();
}

void EmergencyStop::setDisabledReason(const QString &sentence)
{
    if (sentence == m_disabledReason)
        return;
    m_disabledReason = sentence;
    if (!sentence.isEmpty())
        lock();
    showLock();
}

void EmergencyStop::lock()
{
    m_relock.stop();
    m_unlock->setChecked(false);
}

void EmergencyStop::showLock()
{
    const bool unlocked = m_unlock->isChecked();
    m_unlock->setEnabled(m_disabledReason.isEmpty());
    m_unlock->setToolTip(!m_disabledReason.isEmpty() ? m_disabledReason
                                                     : tr("Unlocks the emergency stop for %1 s").arg(kUnlockedMs / 1000));
    m_stop->setDisabledReason(!m_disabledReason.isEmpty() ? m_disabledReason
                                  : unlocked              ? QString()
                                                          : tr("Locked: unlock it first"));
    QPalette colors;
    if (unlocked)
        colors.setColor(QPalette::ButtonText, stateColors(palette()).alarm);
    m_stop->setPalette(colors);
}

QString EmergencyStop::word(bool onTwoLines)
{
    QString text = tr("Emergency stop");
    return onTwoLines ? text.replace(QLatin1Char(' '), QLatin1Char('\n')) : text;
}

void EmergencyStop::setStacked(bool stacked, bool onTwoLines)
{
    m_onTwoLines = onTwoLines;
    nameVehicle(m_named);
    m_box->setDirection(stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_stop->setMinimumWidth(m_stop->roomFor(commandOfVehicle(word(onTwoLines), kAnyVehicle)));
}

int EmergencyStop::leastWidth(bool stacked, bool onTwoLines) const
{
    const int lock = m_unlock->sizeHint().width();
    const int stop = m_stop->roomFor(commandOfVehicle(word(onTwoLines), kAnyVehicle));
    return stacked ? std::max(lock, stop) : lock + kHalfGrid + stop;
}

void EmergencyStop::nameVehicle(int systemId)
{
    m_named = systemId;
    m_stop->setCommand(commandOfVehicle(word(m_onTwoLines), systemId), spokenCommand(tr("Emergency stop"), systemId));
}

} // namespace skyseal::ui

#include "moc_emergency_stop.cpp"
