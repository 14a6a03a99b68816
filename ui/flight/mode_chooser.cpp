#include "ui/flight/mode_chooser.h"

#include "ui/text/vehicle_name.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>

#include <algorithm>

namespace skyseal::ui {

ModeChooser::ModeChooser(QWidget *parent)
    : QWidget(parent), m_box(new QBoxLayout(QBoxLayout::LeftToRight, this)), m_modes(new QComboBox(this)),
      m_set(new HoldButton(tr("Set mode"), this))
{
    m_modes->setObjectName(QStringLiteral("modeBox"));
    m_modes->setAccessibleName(tr("Flight mode to set"));
    m_modes->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_modes->setMinimumContentsLength(10); // of the widest letters: GUIDED_NOGPS
    m_set->setObjectName(QStringLiteral("setModeButton"));
    m_box->setContentsMargins(0, 0, 0, 0);
    m_box->setSpacing(kHalfGrid);
    m_box->addWidget(m_modes);
    m_box->addWidget(m_set);
    connect(m_modes, &QComboBox::currentIndexChanged, this, [this] { m_edited = true; });
    connect(m_set, &HoldButton::confirmed, this, [this] { Q_EMIT confirmed(m_modes->currentText()); });
}

void ModeChooser::showModes(const std::vector<std::string> &modes, const std::string &current, bool anotherVehicle)
{
    const QSignalBlocker quiet(m_modes); // the signal is for changes of the operator
    m_edited = m_edited && !anotherVehicle;
    if (modes != m_known) {
        Q_EMIT modesChanging();
        m_known = modes;
        m_modes->clear();
        for (const std::string &mode : modes)
            m_modes->addItem(fromStd(mode));
        m_modes->setCurrentIndex(modes.empty() ? -1 : 0);
        m_edited = false;
    }
    const int inUse = m_modes->findText(fromStd(current));
    if (inUse == m_modes->currentIndex())
        m_edited = false;
    else if (inUse >= 0 && !m_edited && !m_set->isHeld())
        m_modes->setCurrentIndex(inUse);
}

void ModeChooser::setDisabledReason(const QString &sentence)
{
    const bool unknown = sentence.isEmpty() && m_known.empty();
    m_set->setDisabledReason(unknown ? tr("The modes of this vehicle are not known") : sentence);
    m_modes->setEnabled(m_set->isEnabled());
}

void ModeChooser::setStacked(bool stacked)
{
    m_box->setDirection(stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_set->setMinimumWidth(m_set->roomFor(commandOfVehicle(tr("Set mode"), kAnyVehicle)));
}

int ModeChooser::leastWidth(bool stacked) const
{
    const int box = m_modes->sizeHint().width();
    const int set = m_set->roomFor(commandOfVehicle(tr("Set mode"), kAnyVehicle));
    return stacked ? std::max(box, set) : box + kHalfGrid + set;
}

void ModeChooser::nameVehicle(int systemId)
{
    m_set->setCommand(commandOfVehicle(tr("Set mode"), systemId), spokenCommand(tr("Set mode"), systemId));
}

} // namespace skyseal::ui

#include "moc_mode_chooser.cpp"
