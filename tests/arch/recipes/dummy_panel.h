// Example of a dock panel, for recipes_test: the number of vehicles. It is no part of the product.
#pragma once

#include "ui/dock_panel.h"

class QLabel;

namespace skyseal::ui {

class StationInterface;

class DummyPanel : public DockPanel
{
public:
    DummyPanel(StationInterface &station, QWidget *parent);

    void showViewState(const ViewState &view) override;

private:
    QLabel *m_count;
};

} // namespace skyseal::ui
