#include "ui/mission/mission_panel.h"

#include "core/base/save_file.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/engine/text/event_text.h"
#include "core/vehicle/reasons.h"
#include "ui/ask_file.h"
#include "ui/confirm_box.h"
#include "ui/control_action.h"
#include "ui/result_label.h"
#include "ui/settings.h"
#include "ui/text/command_permits.h"
#include "ui/text/vehicle_name.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"

#include <QtCore/QFile>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QStackedWidget>
#include <QtWidgets/QTreeView>

namespace skyseal::ui {

MissionPanel::MissionPanel(StationInterface &station, QWidget *parent)
    : DockPanel(parent), m_station(station), m_reader(station)
{
    const auto button = [this](const QString &text, const char *name) {
        auto *made = new QPushButton(text, this);
        made->setObjectName(QLatin1String(name));
        made->setAccessibleName(text);
        return made;
    };
    m_read = button(tr("Read from the vehicle"), "missionRead");
    m_send = button(tr("Send a file…"), "missionSend");
    m_save = button(tr("Save as…"), "missionSave");
    m_result = new ResultLabel(this);
    m_result->setObjectName(QStringLiteral("missionResult"));
    m_result->setAccessibleName(tr("Result of the last transfer"));
    auto *tools = new QHBoxLayout;
    tools->setSpacing(kGrid);
    for (QPushButton *made : {m_read, m_send}) // with room for the number of the vehicle
        made->setMinimumWidth(made->sizeHint().width() + fontMetrics().horizontalAdvance(commandOfVehicle({}, kAnyVehicle)));
    for (QPushButton *made : {m_read, m_send, m_save})
        tools->addWidget(made);
    tools->addWidget(m_result, 1);

    m_outdated = new QWidget(this);
    m_outdatedText = new QLabel(m_outdated);
    m_outdatedText->setObjectName(QStringLiteral("missionOutdated"));
    m_outdatedText->setWordWrap(true);
    QFont bold = m_outdatedText->font();
    bold.setBold(true);
    m_outdatedText->setFont(bold);
    m_readAgain = button(tr("Read again"), "missionReadAgain");
    auto *outdated = new QHBoxLayout(m_outdated);
    outdated->setContentsMargins(0, 0, 0, 0);
    outdated->setSpacing(kGrid);
    outdated->addWidget(m_outdatedText, 1);
    outdated->addWidget(m_readAgain);
    m_outdated->hide();

    m_pages = new QStackedWidget(this);
    auto *view = new QTreeView(m_pages);
    view->setObjectName(QStringLiteral("missionView"));
    view->setAccessibleName(tr("Mission items"));
    view->setModel(&m_model);
    view->setRootIsDecorated(false);
    view->setUniformRowHeights(true);
    view->setFrameShape(QFrame::NoFrame);
    view->header()->setStretchLastSection(false);
    view->header()->resizeSection(MissionModel::Number, 6 * kGrid);
    view->header()->setSectionResizeMode(MissionModel::Command, QHeaderView::Stretch);
    view->header()->setSectionResizeMode(MissionModel::Altitude, QHeaderView::ResizeToContents);
    m_empty = new QLabel(m_pages);
    m_empty->setObjectName(QStringLiteral("missionEmpty"));
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(view);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
    column->setSpacing(kGrid);
    column->addLayout(tools);
    column->addWidget(m_outdated);
    column->addWidget(m_pages, 1);

    for (QPushButton *made : {m_read, m_readAgain})
        connect(made, &QPushButton::clicked, this, &MissionPanel::read);
    connect(m_send, &QPushButton::clicked, this, &MissionPanel::askAndSend);
    connect(m_save, &QPushButton::clicked, this, &MissionPanel::askAndSave);
    connect(&station, &StationInterface::eventOccurred, this, &MissionPanel::handleEvent);
    addActions({pressAction(*m_read, Qt::CTRL | Qt::Key_F5), pressAction(*m_send, Qt::CTRL | Qt::Key_F6),
                pressAction(*m_save, Qt::CTRL | Qt::Key_S)});
    showViewState({});
}

void MissionPanel::read()
{
    m_reader.read(m_systemId, m_capabilities);
    say(m_reader.text());
}

void MissionPanel::say(const QString &line)
{
    m_result->showResult(line);
}

QString MissionPanel::kinds()
{
    return tr("Missions (*.waypoints *.txt);;All files (*)");
}

// Another vehicle may be selected while the file dialog is open: the command is for the one that was shown when it opened.
void MissionPanel::askAndSend()
{
    const std::uint8_t systemId = m_systemId;
    const QString title = m_name == 0 ? tr("Send a mission") : tr("Send a mission to vehicle %1").arg(m_name);
    askFile(*this, {.title = title, .kinds = kinds()}, [this, systemId](const QString &file) { sendFile(file, systemId); });
}

void MissionPanel::askAndSave()
{
    const MissionModel::Mission mission = m_mission;
    if (!mission)
        return;
    askFile(*this,
            {.title = tr("Save the mission"),
             .kinds = kinds(),
             .start = QStringLiteral("mission.waypoints"),
             .use = FileQuestion::Use::Write},
            [this, mission](const QString &file) { saveFile(file, mission); });
}

void MissionPanel::sendFile(const QString &file, std::uint8_t systemId)
{
    if (!canSendTo(systemId))
        return;
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly)) {
        say(tr("%1 cannot be read: %2").arg(file, in.errorString()));
        return;
    }
    const auto plan = vehicle::parseMission(in.readAll().toStdString(), file.toStdString());
    if (!plan)
        say(reasonText(plan.error().reason()));
    else if (m_isArmed || !m_changed.isEmpty())
        askToReplace(*plan, systemId);
    else
        send(*plan, systemId, false);
}

/// A vehicle that flies its mission turns to the new one as soon as it has it. A mission of another station is lost.
void MissionPanel::askToReplace(const vehicle::MissionFile &plan, std::uint8_t systemId)
{
    QString text = m_name == 0 ? tr("The vehicle is armed. Replace its mission?")
                               : tr("Vehicle %1 is armed. Replace its mission?").arg(m_name);
    QStringList details;
    if (!m_changed.isEmpty()) {
        text = m_name == 0 ? tr("Replace the mission of another station?")
                           : tr("Replace the mission of another station on vehicle %1?").arg(m_name);
        details << tr("The mission of the vehicle was %1. Read it to see what it is.").arg(m_changed);
        if (m_isArmed)
            details << tr("The vehicle is armed.");
    }
    if (m_isArmed)
        details << tr("While it flies its mission, it turns to the new one at once.");
    askToConfirm({.objectName = QStringLiteral("confirmSendMission"),
                  .title = tr("Send a mission"),
                  .text = text,
                  .details = details.join(QLatin1Char(' ')),
                  .yes = tr("Replace the mission"),
                  .icon = QMessageBox::Warning},
                 this, this, [this, plan, systemId, overwrite = !m_changed.isEmpty()] {
                     if (canSendTo(systemId))
                         send(plan, systemId, overwrite);
                 });
}

/// Says why not.
bool MissionPanel::canSendTo(std::uint8_t systemId)
{
    const bool isAnother = systemId != m_systemId && m_systemId != 0;
    const QString reason = isAnother ? tr("another vehicle is selected") : m_disabledReason;
    if (!reason.isEmpty())
        say(tr("Not sent: %1").arg(reason));
    return reason.isEmpty();
}

void MissionPanel::send(const vehicle::MissionFile &plan, std::uint8_t systemId, bool overwrite)
{
    say(plan.items.size() == 1 ? tr("Sending one item…") : tr("Sending %1 items…").arg(plan.items.size()));
    m_station.perform(systemId,
                      vehicle::WriteMission{.items = plan.items, .withoutHome = plan.withoutHome, .overwrite = overwrite});
}

void MissionPanel::saveFile(const QString &file, const MissionModel::Mission &mission)
{
    const auto saved = skyseal::saveFile(file.toStdString(), asBytes(vehicle::missionText(*mission)));
    say(saved ? tr("Saved %1").arg(file) : reasonText(saved.error().reason()));
}

void MissionPanel::showViewState(const ViewState &view)
{
    const std::uint8_t systemId = view.vehicle ? view.vehicle->state.systemId : 0;
    if (systemId != m_systemId && m_systemId != 0) {
        say({}); // it was the result of another vehicle
        m_reader.forget();
    }
    m_systemId = systemId;
    showName(vehicleToName(view));
    m_capabilities = view.vehicle ? view.vehicle->state.capabilities : 0;
    m_mission = view.vehicle ? view.vehicle->mission : nullptr;
    m_isArmed = view.vehicle && view.vehicle->state.armed;
    m_disabledReason = commandsDisabledReason(view);
    showOutdated(view.vehicle);
    for (QPushButton *button : {m_read, m_readAgain, m_send}) {
        button->setEnabled(m_disabledReason.isEmpty());
        button->setToolTip(m_disabledReason);
    }
    if (m_disabledReason.isEmpty())
        m_read->setToolTip(tr("The mission, and the fence and rally points if the vehicle has them"));
    const bool hasItems = m_mission && !m_mission->empty();
    m_save->setEnabled(hasItems);
    m_save->setToolTip(hasItems ? QString() : tr("There are no items to save"));
    m_pages->setCurrentIndex(hasItems ? 1 : 0);
    const QString why = !view.vehicle ? tr("No vehicle. Its mission is listed here once it has been read.")
        : m_mission                   ? tr("The vehicle has no mission. Send a file to write one.")
                                      : tr("The mission has not been read yet: choose Read from the vehicle.");
    if (m_empty->text() != why)
        m_empty->setText(why);
    if (view.vehicle)
        m_model.setMission(m_mission, view.vehicle->state.missionCurrent,
                           vehicle::keepsHomeFirst(view.vehicle->state.autopilot));
    else
        m_model.setMission(nullptr, -1, false);
}

/// Says which of the lists that were read the vehicle no longer has, and why.
void MissionPanel::showOutdated(const engine::VehicleSnapshot *vehicle)
{
    QStringList lines;
    m_changed.clear();
    if (vehicle) {
        if (!vehicle->missionOutdated.empty() && !(vehicle->missionOutdated == Reason(vehicle::reasons::kPlanIncomplete)))
            m_changed = reasonText(vehicle->missionOutdated);
        if (vehicle->mission && !vehicle->missionOutdated.empty())
            lines << tr("Mission outdated: %1").arg(reasonText(vehicle->missionOutdated));
        if (vehicle->fence && !vehicle->fenceOutdated.empty())
            lines << tr("Fence outdated: %1").arg(reasonText(vehicle->fenceOutdated));
        if (vehicle->rally && !vehicle->rallyOutdated.empty())
            lines << tr("Rally points outdated: %1").arg(reasonText(vehicle->rallyOutdated));
    }
    const QString text = lines.join(QLatin1Char('\n'));
    if (m_outdatedText->text() != text)
        m_outdatedText->setText(text);
    m_outdated->setVisible(!text.isEmpty());
}

/// Where there are several vehicles, says which one is read and written.
void MissionPanel::showName(int vehicle)
{
    if (vehicle == m_name)
        return;
    m_name = vehicle;
    for (const auto &[button, word] : {std::pair(m_read, tr("Read from the vehicle")), {m_send, tr("Send a file…")}}) {
        button->setText(commandOfVehicle(word, vehicle));
        button->setAccessibleName(spokenCommand(word, vehicle));
    }
}

void MissionPanel::applySettings(const Settings &settings)
{
    m_model.setUnits(settings.units);
}

void MissionPanel::handleEvent(const engine::Event &event)
{
    const auto *done = std::get_if<vehicle::MissionResult>(&event);
    if (!done)
        return;
    if (m_reader.handleResult(*done))
        say(m_reader.text());
    else if (done->systemId == m_systemId)
        say(engine::eventText(event, {}).sentence);
}

} // namespace skyseal::ui

#include "moc_mission_panel.cpp"
