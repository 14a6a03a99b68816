#include "ui/window/panel_dock.h"

#include <QtWidgets/QMainWindow>
#include <QtWidgets/QStyleOption>

#include <algorithm>

namespace skyseal::ui {

void PanelDock::initStyleOption(QStyleOptionDockWidget *option) const
{
    QDockWidget::initStyleOption(option);
    if (hasTab())
        option->title.clear();
}

/// QMainWindow shows tabs where several docks that are not hidden share a place.
bool PanelDock::hasTab() const
{
    const auto *window = qobject_cast<const QMainWindow *>(parentWidget());
    if (!window || isFloating())
        return false;
    const auto others = window->tabifiedDockWidgets(const_cast<PanelDock *>(this));
    return std::ranges::any_of(others, [](const QDockWidget *other) { return !other->isHidden(); });
}

} // namespace skyseal::ui
