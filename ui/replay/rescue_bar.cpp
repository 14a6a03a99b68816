#include "ui/replay/rescue_bar.h"

#include "ui/control_action.h"
#include "ui/text/plain_tip.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"
#include "ui/theme/icons.h"
#include "ui/theme/palettes.h"

#include <QtCore/QLocale>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QPushButton>

namespace skyseal::ui {

RescueBar::RescueBar(const UnfinishedRun &run, QWidget *parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("rescueBar"));
    setAttribute(Qt::WA_DeleteOnClose);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    auto *sign = new QLabel(this);
    sign->setPixmap(iconPixmap(QStringLiteral("warning"), 2 * kGrid, stateColors(palette()).warning, devicePixelRatioF()));
    auto *text = named(new QLabel(tr("The last run ended unexpectedly at about %1. Its recording was kept.")
                                      .arg(QLocale().toString(run.ended, QLocale::ShortFormat)),
                                  this),
                       "rescueText", {});
    text->setWordWrap(true);
    auto *replay = named(new QPushButton(tr("Re&play its recording"), this), "rescueReplay",
                         tr("Replay the recording of the last run"));
    replay->setToolTip(plainTip(run.recording));
    replay->setVisible(!run.recording.isEmpty());
    auto *links = named(new QPushButton(tr("&Open its links"), this), "rescueLinks",
                        tr("Open the links of the last run again"));
    links->setToolTip(plainTip(run.links.join(QStringLiteral(", "))));
    links->setVisible(!run.links.isEmpty());
    auto *dismiss = named(new QPushButton(tr("Dis&miss"), this), "rescueDismiss", tr("Dismiss"));
    dismiss->setFlat(true);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(2 * kGrid, kGrid, kGrid, kGrid);
    row->setSpacing(kGrid);
    row->addWidget(sign);
    row->addWidget(text, 1);
    for (QPushButton *button : {replay, links, dismiss})
        row->addWidget(button);
    // Each once: the other offer stays.
    connect(replay, &QPushButton::clicked, this, [this, replay, file = run.recording] {
        replay->setEnabled(false);
        Q_EMIT replayRequested(file);
    });
    connect(links, &QPushButton::clicked, this, [this, links, urls = run.links] {
        links->setEnabled(false);
        Q_EMIT linksRequested(urls);
    });
    connect(dismiss, &QPushButton::clicked, this, &QWidget::close);
    addActions({pressAction(*replay), pressAction(*links), pressAction(*dismiss)});
}

} // namespace skyseal::ui

#include "moc_rescue_bar.cpp"
