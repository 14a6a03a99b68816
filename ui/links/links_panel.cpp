#include "ui/links/links_panel.h"

#include "core/engine/station/snapshot.h"
#include "ui/confirm_box.h"
#include "ui/control_action.h"
#include "ui/empty_text.h"
#include "ui/theme/grid.h"

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>

#include <cmath>

namespace skyseal::ui {

LinksPanel::LinksPanel(StationInterface &station, QWidget *parent) : DockPanel(parent), m_station(station)
{
    auto *add = new QPushButton(tr("Add…"), this);
    add->setObjectName(QStringLiteral("linkAdd"));
    add->setAccessibleName(tr("Add a link"));
    m_remove = new QPushButton(tr("Remove"), this);
    m_remove->setObjectName(QStringLiteral("linkRemove"));
    m_remove->setAccessibleName(tr("Remove the selected link"));
    m_view = new QTreeView(this);
    m_view->setObjectName(QStringLiteral("linkView"));
    m_view->setAccessibleName(tr("Links"));
    m_view->setModel(&m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setFrameShape(QFrame::NoFrame);
    new EmptyText(*m_view, m_model, tr("No links: add one to hear a vehicle."), "linksEmpty");
    const auto room = [this](const char *sample) { return fontMetrics().horizontalAdvance(QLatin1String(sample)) + 3 * kGrid; };
    m_view->header()->resizeSection(LinkModel::Url, room("udpin:255.255.255.255:14550"));
    m_view->header()->resizeSection(LinkModel::State, room("waiting to retry"));
    m_view->header()->resizeSection(LinkModel::Local, room("255.255.255.255:65535"));
    m_view->header()->resizeSection(LinkModel::Remote, room("255.255.255.255:65535"));
    m_view->header()->resizeSection(LinkModel::Received, room("888 kB/s · 888 MB"));
    m_view->header()->resizeSection(LinkModel::Sent, room("888 kB/s · 888 MB"));
    auto *tools = new QHBoxLayout;
    tools->setSpacing(kGrid);
    tools->addWidget(add);
    tools->addWidget(m_remove);
    tools->addStretch(1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
    column->setSpacing(kGrid);
    column->addLayout(tools);
    column->addWidget(m_view, 1);
    m_gateway = new GatewaySection(station, this);
    column->addWidget(m_gateway);

    connect(m_gateway, &GatewaySection::servingChanged, this, &LinksPanel::servingChanged);
    connect(m_gateway, &GatewaySection::sharingChanged, this, &LinksPanel::sharingChanged);
    connect(add, &QPushButton::clicked, this, &LinksPanel::addRequested);
    connect(m_remove, &QPushButton::clicked, this, &LinksPanel::removeChosen);
    const auto allow = [this] {
        const bool any = m_view->currentIndex().isValid();
        m_remove->setEnabled(any);
        m_remove->setToolTip(any ? QString() : tr("Select a link first"));
    };
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, allow);
    connect(&m_model, &LinkModel::modelReset, this, allow);
    allow();
    addAction(pressAction(*m_remove, Qt::ALT | Qt::SHIFT | Qt::Key_X));
    addActions(m_gateway->actions());
}

/// Asks if an armed vehicle is at the link.
void LinksPanel::removeChosen()
{
    const auto *link = m_model.linkAt(m_view->currentIndex().row());
    if (!link)
        return;
    QStringList armed;
    for (const engine::VehicleSnapshot &vehicle : m_shown->vehicles)
        if (vehicle.link == link->id && vehicle.state.armed)
            armed << QString::number(vehicle.state.systemId);
    if (armed.isEmpty())
        return m_station.removeLink(link->id);
    askToConfirm({.objectName = QStringLiteral("confirmRemoveLink"),
                  .title = tr("Remove the link"),
                  .text = armed.size() == 1
                      ? tr("Vehicle %1 on this link is armed. Remove the link?").arg(armed.first())
                      : tr("Vehicles %1 on this link are armed. Remove the link?").arg(armed.join(QStringLiteral(", "))),
                  .details = tr("Without this link, its vehicles cannot be commanded from here, and failsafes may trigger."),
                  .yes = tr("Remove"),
                  .icon = QMessageBox::Warning},
                 this, this, [this, id = link->id] { m_station.removeLink(id); });
}

void LinksPanel::showViewState(const ViewState &view)
{
    const SnapshotPtr &station = view.station();
    constexpr double kLinksRefreshSeconds = 0.5;
    if (!station)
        return;
    m_shown = station;
    const bool sameCount = static_cast<std::size_t>(m_model.rowCount()) == station->links.size();
    if (sameCount && std::abs(station->time - m_shownAt) < kLinksRefreshSeconds)
        return;
    m_shownAt = station->time;
    m_model.setLinks(station->links);
    m_gateway->showSnapshot(*station);
}

void LinksPanel::applySettings(const Settings &settings)
{
    m_gateway->apply(settings.serving);
}

} // namespace skyseal::ui

#include "moc_links_panel.cpp"
