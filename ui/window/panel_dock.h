// A dock of the window. While it is one of several tabs, its title bar has only the buttons: the tab says the name already.
#pragma once

#include <QtWidgets/QDockWidget>

namespace skyseal::ui {

class PanelDock : public QDockWidget
{
public:
    using QDockWidget::QDockWidget;

protected:
    void initStyleOption(QStyleOptionDockWidget *option) const override;

private:
    bool hasTab() const;
};

} // namespace skyseal::ui
