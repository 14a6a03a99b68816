#include "ui/window/tab_stops.h"

#include <QtCore/QSet>
#include <QtWidgets/QScrollArea>

namespace skyseal::ui {

namespace {

void scrollTo(QWidget &control)
{
    for (QWidget *at = control.parentWidget(); at; at = at->parentWidget())
        if (auto *scroll = qobject_cast<QScrollArea *>(at))
            scroll->ensureWidgetVisible(&control);
}

} // namespace

bool isInSight(const QWidget &widget)
{
    QRect seen = widget.rect();
    for (const QWidget *at = &widget; at->isVisible() && !at->isWindow(); at = at->parentWidget())
        seen = seen.translated(at->pos()) & at->parentWidget()->rect();
    return widget.isVisible() && !seen.isEmpty();
}

bool moveFocusInSight(const QWidget &window, const std::function<bool()> &step)
{
    QSet<const QWidget *> passed;
    while (step()) {
        QWidget *now = window.focusWidget();
        if (!window.isVisible() || !now || passed.contains(now))
            return true; // all around
        scrollTo(*now);
        if (isInSight(*now))
            return true;
        passed.insert(now);
    }
    return false;
}

} // namespace skyseal::ui
