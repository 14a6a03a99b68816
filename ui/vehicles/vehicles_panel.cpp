#include "ui/vehicles/vehicles_panel.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/control_action.h"
#include "ui/list_keys.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"

#include <QtGui/QKeyEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QStackedWidget>
#include <QtWidgets/QTreeView>

#include <algorithm>

namespace skyseal::ui {

namespace {

QTreeView *makeList(QAbstractItemModel *model, QWidget *parent)
{
    auto *list = named(new QTreeView(parent), "vehicleList", VehiclesPanel::tr("Vehicles"));
    list->setModel(model);
    list->setRootIsDecorated(false);
    list->setUniformRowHeights(true); // so that a change of one cell repaints it, without measuring the others
    list->setFrameShape(QFrame::NoFrame);
    list->setAlternatingRowColors(true);
    list->setAllColumnsShowFocus(true);
    list->setIconSize({2 * kGrid, 2 * kGrid});
    list->setSortingEnabled(true);
    list->sortByColumn(VehicleListRow::Vehicle, Qt::AscendingOrder);
    QFont bold = list->font(); // that of the selected vehicle
    bold.setBold(true);
    const auto room = [metrics = QFontMetrics(bold)](const QString &sample) {
        return metrics.horizontalAdvance(sample) + 3 * kGrid;
    };
    const QString sealed = QCoreApplication::translate("skyseal::ui::VehicleListRow", "Sealed · %1");
    using enum VehicleListRow::Column;
    const std::pair<int, QString> samples[] = {{Vehicle, QStringLiteral("MM 255 · air-88")},
                                               {Kind, QStringLiteral("quadrotor M")},
                                               {Mode, QStringLiteral("ALT_HOLD")},
                                               {Armed, VehiclesPanel::tr("Disarmed")},
                                               {Battery, VehiclesPanel::tr("%1 · low").arg(QStringLiteral("88 %"))},
                                               {Link, VehiclesPanel::tr("%1 · poor").arg(QStringLiteral("88 %"))},
                                               {LastFrame, VehiclesPanel::tr("Last frame") + QStringLiteral("MM")},
                                               {Lock, QStringLiteral("MM") + sealed.arg(QStringLiteral("ChaCha20-Poly1305"))}};
    for (const auto &[column, sample] : samples)
        list->header()->resizeSection(column, room(sample));
    return list;
}

} // namespace

VehiclesPanel::VehiclesPanel(StationInterface &station, QWidget *parent) : DockPanel(parent), m_station(station)
{
    m_clock.start();
    m_order.setSourceModel(&m_model);
    m_typed = named(new QLineEdit(this), "vehicleFilter", tr("Filter vehicles"));
    m_typed->setPlaceholderText(tr("Number or words, such as \"rover armed\""));
    m_typed->setClearButtonEnabled(true);
    m_typed->installEventFilter(this);
    m_count = named(new QLabel(this), "vehicleCount", tr("Vehicles shown"));
    m_remove = named(new QPushButton(tr("Remove from the list"), this), "vehicleRemove",
                     tr("Remove the lost vehicle from the list"));
    m_list = makeList(&m_order, this);
    m_list->installEventFilter(this);
    m_pages = new QStackedWidget(this);
    m_pages->addWidget(m_list);
    m_pages->addWidget(makeEmptyPage());
    auto *tools = new QHBoxLayout;
    tools->setSpacing(kGrid);
    tools->addWidget(m_typed, 1);
    tools->addWidget(m_count, 1);
    tools->addWidget(m_remove);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
    column->setSpacing(kGrid);
    column->addLayout(tools);
    column->addWidget(m_pages, 1);
    setFocusProxy(m_list);
    addActions({focusAction(*m_typed, tr("Find a vehicle"), Qt::CTRL | Qt::SHIFT | Qt::Key_V),
                pressAction(*m_remove, Qt::ALT | Qt::SHIFT | Qt::Key_Z)});

    connect(m_typed, &QLineEdit::textChanged, this, [this](const QString &typed) {
        m_order.setTyped(typed);
        showCount();
    });
    connect(m_list, &QTreeView::clicked, this, &VehiclesPanel::choose);
    connect(m_list, &QTreeView::activated, this, &VehiclesPanel::choose); // by Enter
    connect(m_connect, &QPushButton::clicked, this, &VehiclesPanel::connectRequested);
    connect(m_remove, &QPushButton::clicked, this, &VehiclesPanel::removeCurrent);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &VehiclesPanel::showRemove);
    showRemove();
    connect(&station, &StationInterface::eventOccurred, this,
            [this](const engine::Event &event) { m_refusals.handleEvent(event, now()); });
}

QWidget *VehiclesPanel::makeEmptyPage()
{
    auto *page = new QWidget(m_pages);
    m_empty = named(new QLabel(page), "vehiclesEmpty", {});
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_connect = named(new QPushButton(tr("Connect…"), page), "vehiclesConnect", tr("Add a link"));
    auto *column = new QVBoxLayout(page);
    column->addStretch(1);
    column->addWidget(m_empty);
    column->addWidget(m_connect, 0, Qt::AlignHCenter);
    column->addStretch(1);
    return page;
}

double VehiclesPanel::now() const
{
    return static_cast<double>(m_clock.elapsed()) / 1000;
}

void VehiclesPanel::showViewState(const ViewState &view)
{
    m_shown = view;
    if (isExposed())
        refresh();
}

void VehiclesPanel::exposedChanged(bool exposed)
{
    if (exposed)
        refresh();
}

void VehiclesPanel::refresh()
{
    std::vector<VehicleListRow> rows;
    const std::vector<Alert> none;
    for (std::size_t i = 0; i < m_shown.vehicles().size(); ++i) {
        const std::uint8_t id = m_shown.vehicles()[i].state.systemId;
        ViewState own = viewOf(m_shown.snapshot, id);
        own.live = m_shown.live;
        own.key = m_shown.key;
        own.plainRun = m_shown.plainRun;
        m_refusals.mark(own, now());
        rows.push_back(vehicleListRowOf(own, own.isReplay() ? none : m_alerts));
        rows.back().selected = m_shown.vehicle && m_shown.vehicle->state.systemId == id;
    }
    m_model.setVehicles(std::move(rows));
    keepOrder();
    followSelection();
    showCount();
    showRemove();
}

/// The row on which the cursor stands; 0 without one.
std::uint8_t VehiclesPanel::currentVehicle() const
{
    return static_cast<std::uint8_t>(m_list->currentIndex().data(VehicleListModel::SystemIdRole).toInt());
}

/// Only what is not heard can be removed: the next frame would show it again.
void VehiclesPanel::showRemove()
{
    const auto &vehicles = m_shown.vehicles();
    const auto at = std::ranges::find(vehicles, currentVehicle(), [](const auto &one) { return one.state.systemId; });
    const bool isLost = at != vehicles.end() && at->state.lost;
    m_remove->setEnabled(isLost && !m_shown.isReplay());
    m_remove->setToolTip(m_shown.isReplay() ? tr("A replay is shown")
                             : isLost       ? tr("It appears again as soon as it is heard")
                                            : tr("Select a vehicle whose link is lost"));
}

void VehiclesPanel::removeCurrent()
{
    if (const std::uint8_t systemId = currentVehicle(); systemId != 0)
        m_station.forgetVehicle(systemId);
}

/// Nothing moves while the pointer is over the list: a click would hit another vehicle.
void VehiclesPanel::keepOrder()
{
    if (!m_list->viewport()->underMouse() && m_order.isOutdated())
        m_order.renew();
}

void VehiclesPanel::showCount()
{
    const int all = m_model.rowCount(), shown = m_order.rowCount();
    const bool held = m_list->viewport()->underMouse() && m_order.isOutdated();
    const QString count = all == 0 ? QString()
        : held                     ? tr("%1 of %2 · order kept under the pointer").arg(shown).arg(all)
                                   : tr("%1 of %2").arg(shown).arg(all);
    if (m_count->text() != count)
        m_count->setText(count);
    const QString why = all == 0 ? tr("No vehicle. A vehicle appears here as soon as it is heard.")
                                 : tr("No vehicle matches \"%1\".").arg(m_typed->text());
    if (shown == 0 && m_empty->text() != why)
        m_empty->setText(why);
    m_connect->setVisible(all == 0);
    m_pages->setCurrentIndex(shown == 0 ? 1 : 0);
}

/// Takes the cursor of the list along when another vehicle is selected elsewhere, unless it is in use.
void VehiclesPanel::followSelection()
{
    const std::uint8_t selected = m_shown.vehicle ? m_shown.vehicle->state.systemId : 0;
    if (selected == m_selected)
        return;
    m_selected = selected;
    if (selected != 0 && !m_list->hasFocus() && !m_list->viewport()->underMouse())
        m_list->setCurrentIndex(m_order.mapFromSource(m_model.index(m_model.rowOf(selected), 0)));
}

void VehiclesPanel::choose(const QModelIndex &at)
{
    if (at.isValid())
        Q_EMIT vehicleChosen(static_cast<std::uint8_t>(at.data(VehicleListModel::SystemIdRole).toInt()));
}

bool VehiclesPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return DockPanel::eventFilter(watched, event);
    auto *key = static_cast<QKeyEvent *>(event);
    if (watched == m_list) {
        const bool isText = !key->text().isEmpty() && key->text().front().isLetterOrNumber()
            && !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
        if (!isText)
            return DockPanel::eventFilter(watched, event);
        m_typed->setFocus(Qt::OtherFocusReason);
        m_typed->end(false);
        QApplication::sendEvent(m_typed, event);
        return true;
    }
    if (takeListKey(*key, *m_list, [this] { choose(m_order.rowCount() == 1 ? m_order.index(0, 0) : m_list->currentIndex()); }))
        return true;
    if (key->key() != Qt::Key_Escape || m_typed->text().isEmpty())
        return DockPanel::eventFilter(watched, event);
    m_typed->clear();
    return true;
}

} // namespace skyseal::ui

#include "moc_vehicles_panel.cpp"
