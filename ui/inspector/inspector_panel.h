// The inspector: all received message types, and the fields of the selected one, live. The station collects the data only
// while the panel is visible.
#pragma once

#include "ui/dock_panel.h"
#include "ui/inspector/field_model.h"
#include "ui/inspector/inspector_model.h"
#include "ui/view_state.h"

class QTreeView;
class QSortFilterProxyModel;

namespace skyseal::ui {

class InspectorPanel : public DockPanel
{
    Q_OBJECT

public:
    explicit InspectorPanel(StationInterface &station, QWidget *parent = nullptr);

    void showViewState(const ViewState &view) override;

protected:
    void exposedChanged(bool seen) override;

private:
    void showFields();

    StationInterface &m_station;
    InspectorModel m_messages;
    FieldModel m_fields;
    QSortFilterProxyModel *m_filter;
    QTreeView *m_list, *m_detail;
    double m_shownAt = -1;
    bool m_filled = false; ///< by the station, since the panel is visible; before that its list is empty
};

} // namespace skyseal::ui
