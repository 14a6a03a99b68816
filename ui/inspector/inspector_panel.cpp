#include "ui/inspector/inspector_panel.h"

#include "core/engine/station/snapshot.h"
#include "ui/control_action.h"
#include "ui/empty_text.h"
#include "ui/theme/grid.h"

#include <QtCore/QSortFilterProxyModel>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QSplitter>
#include <QtWidgets/QTreeView>
#include <QtWidgets/QVBoxLayout>

#include <cmath>

namespace skyseal::ui {

namespace {

constexpr double kRefreshSeconds = 0.25; ///< faster changes cannot be read

QTreeView *makeView(QAbstractItemModel *model, const QString &accessible, QWidget *parent)
{
    auto *view = new QTreeView(parent);
    view->setAccessibleName(accessible);
    view->setModel(model);
    view->setRootIsDecorated(false);
    view->setUniformRowHeights(true);
    view->setFrameShape(QFrame::NoFrame);
    view->setAlternatingRowColors(true);
    return view;
}

} // namespace

InspectorPanel::InspectorPanel(StationInterface &station, QWidget *parent)
    : DockPanel(parent), m_station(station), m_fields(mavlink::Dialect::builtin()), m_filter(new QSortFilterProxyModel(this))
{
    m_filter->setSourceModel(&m_messages);
    m_filter->setFilterKeyColumn(InspectorModel::Name);
    m_filter->setFilterCaseSensitivity(Qt::CaseInsensitive);
    auto *wanted = new QLineEdit(this);
    wanted->setObjectName(QStringLiteral("inspectorFilter"));
    wanted->setPlaceholderText(tr("Filter by name"));
    wanted->setAccessibleName(tr("Filter message types"));
    wanted->setClearButtonEnabled(true);
    connect(wanted, &QLineEdit::textChanged, m_filter, &QSortFilterProxyModel::setFilterFixedString);

    m_list = makeView(m_filter, tr("Message types"), this);
    m_list->setObjectName(QStringLiteral("inspectorList"));
    new EmptyText(*m_list, m_messages, tr("Each type of message is listed here once it arrives."), "inspectorEmpty");
    m_detail = makeView(&m_fields, tr("Fields of the selected message"), this);
    m_detail->setObjectName(QStringLiteral("inspectorFields"));
    new EmptyText(*m_detail, m_fields, tr("Select a type of message to see its fields."), "fieldsEmpty");
    const QFontMetrics metrics(font());
    const auto room = [&](const char *sample) { return metrics.horizontalAdvance(QLatin1String(sample)) + 3 * kGrid; };
    m_list->header()->setStretchLastSection(true);
    m_list->header()->resizeSection(InspectorModel::Name, room("GLOBAL_POSITION_INT_COV"));
    m_list->header()->resizeSection(InspectorModel::Id, room("88888"));
    m_list->header()->resizeSection(InspectorModel::Sender, room("255 / 255"));
    m_list->header()->resizeSection(InspectorModel::Rate, room("1888.8 /s"));
    m_list->header()->resizeSection(InspectorModel::Count, room("88 888 888"));
    m_detail->header()->resizeSection(FieldModel::Name, room("onboard_control_sensors"));
    m_detail->header()->resizeSection(FieldModel::Value, room("0 (MAV_AUTOPILOT_ARDUPILOTMEGA)"));
    m_detail->header()->resizeSection(FieldModel::Unit, room("cdeg/s"));

    auto *split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(m_list);
    split->addWidget(m_detail);
    split->setChildrenCollapsible(false);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
    column->setSpacing(kGrid);
    column->addWidget(wanted);
    column->addWidget(split, 1);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &InspectorPanel::showFields);
    addAction(focusAction(*wanted, tr("Find a message type"), Qt::ALT | Qt::SHIFT | Qt::Key_I));
}

void InspectorPanel::showViewState(const ViewState &view)
{
    if (!isExposed() || !view.snapshot)
        return;
    m_filled = m_filled || !view.snapshot->inspector.empty();
    if (!m_filled || std::abs(view.snapshot->time - m_shownAt) < kRefreshSeconds)
        return;
    m_shownAt = view.snapshot->time;
    m_messages.setRows(view.snapshot->inspector);
    showFields();
}

void InspectorPanel::showFields()
{
    m_fields.setMessage(m_messages.rowAt(m_filter->mapToSource(m_list->currentIndex()).row()));
}

void InspectorPanel::exposedChanged(bool seen)
{
    m_filled = false;
    m_station.setInspecting(seen);
}

} // namespace skyseal::ui

#include "moc_inspector_panel.cpp"
