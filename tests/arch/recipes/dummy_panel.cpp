#include "ui/dummy/dummy_panel.h"

#include "core/engine/station/snapshot.h"
#include "ui/view_state.h"

#include <QtWidgets/QLabel>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

DummyPanel::DummyPanel(StationInterface &, QWidget *parent) : DockPanel(parent), m_count(new QLabel(this))
{
    auto *column = new QVBoxLayout(this);
    column->addWidget(m_count);
}

void DummyPanel::showViewState(const ViewState &view)
{
    m_count->setText(QString::number(view.vehicles().size()));
}

} // namespace skyseal::ui
