#include "ui/parameters/parameters_panel.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/confirm_box.h"
#include "ui/control_action.h"
#include "ui/empty_text.h"
#include "ui/result_label.h"
#include "ui/text/command_permits.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_name.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"

#include <QtCore/QLocale>
#include <QtCore/QSortFilterProxyModel>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>

#include <utility>

namespace skyseal::ui {

namespace {

const QString kParameterQuestion = QStringLiteral("confirmParameter");

} // namespace

ParametersPanel::ParametersPanel(StationInterface &station, QWidget *parent)
    : DockPanel(parent), m_station(station), m_shown(new QSortFilterProxyModel(this))
{
    m_shown->setSourceModel(&m_model);
    m_shown->setFilterKeyColumn(ParameterModel::Name);
    m_shown->setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_fetch = new QPushButton(tr("Fetch"), this);
    m_fetch->setObjectName(QStringLiteral("parameterFetch"));
    m_fetch->setAccessibleName(tr("Fetch the parameters"));
    m_fetch->setMinimumWidth(m_fetch->sizeHint().width() + fontMetrics().horizontalAdvance(commandOfVehicle({}, kAnyVehicle)));
    auto *wanted = new QLineEdit(this);
    wanted->setObjectName(QStringLiteral("parameterFilter"));
    wanted->setPlaceholderText(tr("Filter by name"));
    wanted->setAccessibleName(tr("Filter parameters"));
    wanted->setClearButtonEnabled(true);
    connect(wanted, &QLineEdit::textChanged, this, [this](const QString &typed) {
        m_shown->setFilterFixedString(typed);
        showCount();
    });
    m_progress = new QProgressBar(this);
    m_progress->setAccessibleName(tr("Parameters fetched"));
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(16 * kGrid);
    m_count = new QLabel(this);
    m_count->setObjectName(QStringLiteral("parameterCount"));
    m_count->setMinimumWidth(fontMetrics().horizontalAdvance(tr("%1 of %2").arg(8888).arg(8888)));
    auto *tools = new QHBoxLayout;
    tools->setSpacing(kGrid);
    tools->addWidget(m_fetch);
    tools->addWidget(wanted, 1);
    tools->addWidget(m_progress);
    tools->addWidget(m_count);

    auto *view = new QTreeView(this);
    view->setObjectName(QStringLiteral("parameterView"));
    view->setAccessibleName(tr("Parameters"));
    view->setModel(m_shown);
    view->setRootIsDecorated(false);
    view->setUniformRowHeights(true);
    view->setFrameShape(QFrame::NoFrame);
    view->setAlternatingRowColors(true);
    new EmptyText(*view, m_model, tr("Parameters are listed here once they are fetched."), "parameterEmpty");
    view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                          | QAbstractItemView::AnyKeyPressed);
    view->header()->resizeSection(ParameterModel::Name, fontMetrics().horizontalAdvance(QLatin1Char('W')) * 17);
    view->header()->resizeSection(ParameterModel::Value,
                                  fontMetrics().horizontalAdvance(QStringLiteral("-8888888.88")) + 3 * kGrid);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
    column->setSpacing(kGrid);
    m_result = new ResultLabel(this);
    m_result->setObjectName(QStringLiteral("parameterResult"));
    m_result->setAccessibleName(tr("Result of the last fetch"));
    tools->insertWidget(1, m_result, 1);
    column->addLayout(tools);
    column->addWidget(view, 1);

    // A key edits the value, wherever in its row the operator is: a list of rows has no key that goes from column to column.
    connect(view->selectionModel(), &QItemSelectionModel::currentChanged, view, [view](const QModelIndex &now) {
        if (now.isValid() && now.column() != ParameterModel::Value)
            view->setCurrentIndex(now.siblingAtColumn(ParameterModel::Value));
    });
    connect(m_fetch, &QPushButton::clicked, this, &ParametersPanel::fetch);
    connect(&m_model, &ParameterModel::writeRequested, this, &ParametersPanel::writeOrAsk);
    connect(&station, &StationInterface::eventOccurred, this, &ParametersPanel::handleEvent);
    addActions({pressAction(*m_fetch, Qt::CTRL | Qt::Key_F7),
                focusAction(*wanted, tr("Find a parameter"), Qt::ALT | Qt::SHIFT | Qt::Key_T)});
    showViewState({});
}

void ParametersPanel::fetch()
{
    m_result->showResult(m_silence > 0 ? tr("Requested, but the vehicle has been silent for %1").arg(durationText(m_silence))
                                       : tr("Requested…"));
    m_station.perform(m_systemId, vehicle::ReadParameters{});
}

/// A parameter takes effect at once, and some of them change how the vehicle flies. The question comes after the field has
/// closed, which would otherwise take the loss of its focus for the same entry once more.
void ParametersPanel::writeOrAsk(const QString &name, double value)
{
    const auto before = m_model.find(name);
    if (!m_disabledReason.isEmpty() || !m_isArmed || !before)
        return write(name, value);
    m_model.showNote(name, tr("waits for your confirmation"));
    const auto ask = [this, value, before = *before, systemId = m_systemId] {
        if (systemId == m_systemId)
            askToWrite(before, value);
    };
    QMetaObject::invokeMethod(this, ask, Qt::QueuedConnection);
}

void ParametersPanel::askToWrite(const vehicle::Parameter &before, double value)
{
    const QString name = fromStd(vehicle::parameterLabel(before));
    const QString from = ParameterModel::valueText(before), to = QString::number(value, 'g', QLocale::FloatingPointShortest);
    QMessageBox *box = askToConfirm({.objectName = kParameterQuestion,
                                     .title = tr("Write a parameter"),
                                     .text = m_name == 0 ? tr("The vehicle is armed. Change %1?").arg(name)
                                                         : tr("Vehicle %1 is armed. Change %2?").arg(m_name).arg(name),
                                     .details = tr("%1: from %2 to %3. The change takes effect at once.").arg(name, from, to),
                                     .yes = tr("Write %1").arg(to),
                                     .icon = QMessageBox::Warning},
                                    this, this, [this, name, value, systemId = m_systemId] {
                                        if (systemId == m_systemId)
                                            write(name, value);
                                    });
    // Only now: an older question, which ends with this one, may have been about the same parameter.
    m_model.showNote(name, tr("waits for your confirmation"));
    connect(box, &QMessageBox::finished, this, [this, name, systemId = m_systemId](int result) {
        if (result != QMessageBox::Yes && systemId == m_systemId)
            m_model.showNote(name, tr("not written: not confirmed"));
    });
}

void ParametersPanel::write(const QString &name, double value)
{
    const auto [component, parameter] = vehicle::parameterName(name.toStdString());
    if (!m_disabledReason.isEmpty())
        return m_model.written({.name = parameter, .value = value, .componentId = component}, false, m_disabledReason);
    m_model.showWriting(name, value);
    m_station.perform(m_systemId, vehicle::WriteParameter{parameter, value, component});
}

void ParametersPanel::showViewState(const ViewState &view)
{
    const std::uint8_t systemId = view.vehicle ? view.vehicle->state.systemId : 0;
    if (const std::uint8_t before = std::exchange(m_systemId, systemId); before != systemId && before != 0) {
        m_result->showResult({}); // it was that of another vehicle, as the question is
        m_model.forgetResults();
        if (auto *open = findChild<QMessageBox *>(kParameterQuestion))
            open->reject();
    }
    m_isArmed = view.vehicle && view.vehicle->state.armed;
    m_name = vehicleToName(view);
    showName(m_name);
    m_silence = view.stale() ? view.vehicle->state.messageAge : 0;
    m_disabledReason = commandsDisabledReason(view);
    m_fetch->setEnabled(m_disabledReason.isEmpty());
    m_fetch->setToolTip(m_disabledReason);
    m_model.setParameters(view.vehicle ? view.vehicle->parameters : nullptr);
    const int have = m_model.rowCount();
    m_all = view.vehicle ? static_cast<int>(view.vehicle->parametersExpected) : 0;
    showCount();
    m_progress->setVisible(m_all > 0 && have < m_all);
    m_progress->setMaximum(qMax(1, m_all));
    m_progress->setValue(have);
}

/// Those that are listed, of all that the vehicle has.
void ParametersPanel::showCount()
{
    const QString count = m_all > 0 ? tr("%1 of %2").arg(m_shown->rowCount()).arg(m_all) : tr("not fetched");
    if (m_count->text() != count)
        m_count->setText(count);
}

/// Where there are several vehicles, says which one is read and written.
void ParametersPanel::showName(int vehicle)
{
    m_model.setName(vehicle);
    const QString word = commandOfVehicle(tr("Fetch"), vehicle);
    if (m_fetch->text() == word)
        return;
    m_fetch->setText(word);
    m_fetch->setAccessibleName(spokenCommand(tr("Fetch the parameters"), vehicle));
}

void ParametersPanel::handleEvent(const engine::Event &event)
{
    const auto *written = std::get_if<vehicle::ParameterResult>(&event);
    if (written && written->action == vehicle::ParameterAction::ReadList && written->systemId == m_systemId)
        m_result->showResult(!written->ok                  ? tr("Not fetched: %1").arg(reasonText(written->reason))
                                 : written->reason.empty() ? tr("Fetched")
                                                           : tr("Fetched; %1").arg(reasonText(written->reason)));
    if (written && written->action == vehicle::ParameterAction::Write && written->systemId == m_systemId)
        m_model.written(written->parameter, written->ok, reasonText(written->reason));
}

} // namespace skyseal::ui

#include "moc_parameters_panel.cpp"
