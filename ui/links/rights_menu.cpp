#include "ui/links/rights_menu.h"

#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>

namespace skyseal::ui {

RightsMenu::RightsMenu(QWidget *parent) : QMenu(parent)
{
    setToolTipsVisible(true);
    m_everything = add(tr("&Everything"), tr("Also messages of no class, and of other dialects"), "all");
    addSeparator();
    m_classes = {add(tr("&Missions, fences and rally points"), tr("Not the choice of the item to fly next"), "mission"),
                 add(tr("&Parameters"), {}, "param"),
                 add(tr("&Commands and flight modes"), tr("They command vehicles like this station"), "command"),
                 add(tr("&Files and logs"), {}, "ftp"), add(tr("&Sticks and manual control"), {}, "rc")};
    connect(m_everything, &QAction::triggered, this, &RightsMenu::toggleEverything);
    for (QAction *one : m_classes)
        connect(one, &QAction::triggered, this, &RightsMenu::toggleClass);
}

QAction *RightsMenu::add(const QString &text, const QString &tip, const char *keyword)
{
    QAction *action = addAction(text);
    action->setCheckable(true);
    action->setToolTip(tip);
    action->setObjectName(QLatin1String("serve-") + QLatin1String(keyword));
    action->setData(QLatin1String(keyword));
    return action;
}

void RightsMenu::setRights(const engine::WriteRights &rights)
{
    const QStringList named = QString::fromStdString(rights.toText()).split(QLatin1Char(','));
    m_everything->setChecked(rights == engine::WriteRights::all());
    for (QAction *one : m_classes)
        one->setChecked(m_everything->isChecked() || named.contains(one->data().toString()));
}

engine::WriteRights RightsMenu::rights() const
{
    if (m_everything->isChecked())
        return engine::WriteRights::all();
    QStringList named;
    for (const QAction *one : m_classes) {
        if (one->isChecked())
            named.append(one->data().toString());
    }
    return engine::WriteRights::parse(named.join(QLatin1Char(',')).toStdString()).value_or(engine::WriteRights());
}

void RightsMenu::toggleEverything(bool on)
{
    for (QAction *one : m_classes)
        one->setChecked(on);
    Q_EMIT rightsChosen(rights());
}

void RightsMenu::toggleClass(bool)
{
    m_everything->setChecked(false);
    Q_EMIT rightsChosen(rights());
}

/// Several boxes can be ticked at once: the menu closes by Esc, or by a click beside it.
void RightsMenu::mouseReleaseEvent(QMouseEvent *event)
{
    QAction *action = actionAt(event->position().toPoint());
    if (action && action->isCheckable() && action->isEnabled())
        action->trigger();
    else
        QMenu::mouseReleaseEvent(event);
}

void RightsMenu::keyPressEvent(QKeyEvent *event)
{
    QAction *action = activeAction();
    const bool ticks = event->key() == Qt::Key_Space || event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (ticks && action && action->isCheckable())
        action->trigger();
    else
        QMenu::keyPressEvent(event);
}

} // namespace skyseal::ui

#include "moc_rights_menu.cpp"
