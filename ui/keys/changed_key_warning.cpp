#include "ui/keys/changed_key_warning.h"

#include "ui/keys/fingerprint_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/icons.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QCheckBox>
#include <QtWidgets/QGridLayout>

#include <utility>

namespace skyseal::ui {

ChangedKeyWarning::ChangedKeyWarning(QWidget *parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("changedKey"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    m_icon = new QLabel(this);
    m_icon->setPixmap(iconPixmap(QStringLiteral("warning"), 3 * kGrid, stateColors(palette()).alarm, devicePixelRatioF()));
    m_text = new QLabel(this);
    m_text->setObjectName(QStringLiteral("changedKeyText"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_known = fixedWidthLabel({}, "knownFingerprint", tr("Previous fingerprint"), this);
    m_offered = fixedWidthLabel({}, "offeredFingerprint", tr("Fingerprint of the new key"), this);
    m_accept = new QCheckBox(tr("I have checked the new fingerprint on the device itself: &replace the key"), this);
    m_accept->setObjectName(QStringLiteral("replaceKey"));
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, kGrid);
    grid->setHorizontalSpacing(2 * kGrid);
    grid->setVerticalSpacing(kGrid);
    grid->addWidget(m_icon, 0, 0, Qt::AlignTop);
    grid->addWidget(m_text, 0, 1, 1, 2);
    grid->addWidget(new QLabel(tr("previous"), this), 1, 1, Qt::AlignTop);
    grid->addWidget(m_known, 1, 2);
    grid->addWidget(new QLabel(tr("new"), this), 2, 1, Qt::AlignTop);
    grid->addWidget(m_offered, 2, 2);
    grid->addWidget(m_accept, 3, 1, 1, 2);
    grid->setColumnStretch(2, 1);
    connect(m_accept, &QCheckBox::toggled, this, &ChangedKeyWarning::acceptedChanged);
    hide();
}

void ChangedKeyWarning::showKeys(const QString &name, const channel::PublicKey &known, const channel::PublicKey &offered)
{
    m_text->setText(
        tr("The key of %1 has changed. Either a new key was generated there, or another device is impersonating %1.")
            .arg(name));
    m_known->setText(fingerprintLines(known));
    m_offered->setText(fingerprintLines(offered));
    show();
    Case shown{name, known, offered};
    if (m_shown == shown)
        return;
    m_shown = std::move(shown); // before clearing the tick, which makes the owner query this
    m_accept->setChecked(false);
}

bool ChangedKeyWarning::isAccepted() const
{
    return m_accept->isChecked();
}

} // namespace skyseal::ui

#include "moc_changed_key_warning.cpp"
