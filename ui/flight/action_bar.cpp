#include "ui/flight/action_bar.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "core/vehicle/command_plan.h"
#include "core/vehicle/flight_rules.h"
#include "ui/control_action.h"
#include "ui/flight/altitude_box.h"
#include "ui/flight/confirm_command.h"
#include "ui/flight/emergency_stop.h"
#include "ui/flight/mode_chooser.h"
#include "ui/flight/pre_arm_button.h"
#include "ui/text/vehicle_name.h"
#include "ui/result_label.h"
#include "ui/text/action_permits.h"
#include "ui/text/command_permits.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QEvent>
#include <QtGui/QPainter>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QVBoxLayout>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr int kResultWidth = 22 * kGrid, kBriefResultWidth = 18 * kGrid; ///< pixels, the least

QString belowEachOther(const QString &upper, const QString &lower)
{
    return upper + QLatin1Char('\n') + lower;
}

} // namespace

ActionBar::ActionBar(VehicleCommands &commands, QWidget *parent)
    : QWidget(parent), m_commands(commands), m_arm(new HoldButton(tr("Arm"), this)), m_preArm(new PreArmButton(commands, this)),
      m_altitude(new AltitudeBox(this))
{
    setObjectName(QStringLiteral("actionBar"));
    setAccessibleName(tr("Actions"));
    m_arm->setObjectName(QStringLiteral("armButton"));
    m_altitude->setObjectName(QStringLiteral("takeOffAltitude"));
    m_altitude->setMetres(commands.takeOffAltitude());
    connect(m_altitude, &AltitudeBox::metresChanged, &commands, &VehicleCommands::setTakeOffAltitude);
    connect(&commands, &VehicleCommands::takeOffAltitudeChanged, m_altitude, &AltitudeBox::setMetres);
    addTarget("takeOffButton", tr("Take off"),
              [this] { return vehicle::TakeOff{.altitude = m_altitude->metres(), .prepare = true}; });
    m_targets.back().arming = {tr("Arm and\ntake off"), tr("Arm and\ntake off"), tr("Arm and take off"),
                               tr("Arms the motors, and takes off at once.")};
    addTarget(
        "startMissionButton", tr("Start mission"), [] { return vehicle::StartMission{.prepare = true}; }, true);
    m_targets.back().purpose = tr("Starts or continues the mission.");
    m_targets.back().arming = {tr("Arm and start\nmission"), tr("Arm and\nstart"), tr("Arm and start mission"),
                               tr("Arms the motors, and starts the mission at once.")};
    addTarget("pauseButton", tr("Pause"), [] { return vehicle::Loiter{}; });
    m_targets.back().purpose = tr("Stops and holds the present position; a plane circles it.");
    addTarget("landButton", tr("Land"), [] { return vehicle::Land{}; });
    addTarget("returnButton", tr("RTL"), [] { return vehicle::ReturnToLaunch{}; });
    m_targets.back().purpose = tr("Returns to launch and lands there.");
    m_mode = new ModeChooser(this); // in the order of the tab key
    m_stop = new EmergencyStop(this);
    m_result = new ResultLabel(this);
    m_result->setObjectName(QStringLiteral("commandResult"));
    m_result->setAccessibleName(tr("Result of the last command"));
    m_result->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // takes the height of its row

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kHalfGrid + 1, kGrid, kHalfGrid);
    column->setSpacing(kHalfGrid);
    for (QHBoxLayout *&row : m_rows) {
        row = new QHBoxLayout;
        row->setSpacing(kHalfGrid);
        column->addLayout(row);
    }
    const auto send = [this](const vehicle::VehicleCommand &command) { m_commands.send(m_systemId, command); };
    connect(m_arm, &HoldButton::confirmed, this, [this, send] {
        if (m_armed)
            send(vehicle::Disarm{});
        else
            sendOrAsk(m_commands, m_systemId, vehicle::Arm{}, window());
    });
    connect(m_mode, &ModeChooser::confirmed, this, [send](const QString &mode) { send(vehicle::SetMode{mode.toStdString()}); });
    connect(m_mode, &ModeChooser::modesChanging, this,
            [this] { endHolds({&m_mode->button()}, tr("the vehicle's modes have changed")); });
    connect(m_stop, &EmergencyStop::confirmed, this, [send] { send(vehicle::Disarm{.force = true}); });
    for (HoldButton *button : holdButtons()) {
        button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
        connect(button, &HoldButton::aborted, this, [this] { say(tr("Not sent: hold the button to confirm"), true); });
    }
    m_arm->setMinimumHeight(kTargetHeight);
    m_preArm->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
    m_preArm->setMinimumHeight(kTargetHeight);
    connect(&commands, &VehicleCommands::resultReported, this, &ActionBar::say);
    addAction(new ControlAction(*m_preArm, QStringLiteral("press_preArmButton"), tr("Checklist and pre-arm checks…"),
                                Qt::CTRL | Qt::Key_L, [this] { m_preArm->click(); }));
    addActions(m_stop->actions());
    showViewState({});
    arrange();
}

QString ActionBar::Target::textIn(Shape shape) const
{
    return breaks && shape == Shape::BriefRow ? QString(word).replace(QLatin1Char(' '), QLatin1Char('\n')) : word;
}

void ActionBar::addTarget(const char *objectName, const QString &word, std::function<vehicle::VehicleCommand()> command,
                          bool breaks)
{
    auto *button = new HoldButton(word, this);
    button->setObjectName(QLatin1String(objectName));
    button->setMinimumHeight(kTargetHeight);
    connect(button, &HoldButton::confirmed, this, [this, command] { sendOrAsk(m_commands, m_systemId, command(), window()); });
    m_targets.push_back({button, word, breaks, std::move(command)});
}

std::vector<HoldButton *> ActionBar::holdButtons() const
{
    std::vector<HoldButton *> all{m_arm, &m_mode->button(), &m_stop->button()};
    for (const Target &target : m_targets)
        all.push_back(target.button);
    return all;
}

std::vector<std::vector<ActionBar::Piece>> ActionBar::rowsOf(Shape shape) const
{
    const bool brief = isBrief(shape), narrow = shape == Shape::BriefRow, stacked = shape == Shape::OneRow || narrow;
    const QString vehicle = nameOf(kAnyVehicle, brief);
    const Piece gap{nullptr, kGrid};
    const std::vector<Piece> arming{
        {m_arm, std::max({m_arm->roomFor(tr("Arm")), m_arm->roomFor(tr("Disarm")), m_arm->roomFor(vehicle)})},
        {m_preArm, m_preArm->leastWidth(narrow)}};
    std::vector<Piece> flight{{m_altitude, m_altitude->sizeHint().width()}};
    for (const Target &target : m_targets) {
        const int word = std::max(target.button->roomFor(target.textIn(shape)),
                                  target.button->roomFor(target.armingTextIn(shape)));
        flight.push_back({target.button, std::max(word, target.button->roomFor(vehicle)), 1});
    }
    const Piece mode{m_mode, m_mode->leastWidth(stacked)}, stop{m_stop, m_stop->leastWidth(stacked, narrow)};
    const Piece result{m_result, narrow ? kBriefResultWidth : kResultWidth, narrow ? 4 : 1};
    const auto join = [](std::initializer_list<std::vector<Piece>> parts) {
        std::vector<Piece> row;
        for (const auto &part : parts)
            row.insert(row.end(), part.begin(), part.end());
        return row;
    };
    switch (shape) {
    case Shape::OneRow:
    case Shape::BriefRow: return {join({arming, {gap}, flight, {gap, mode, gap, stop, gap, result}})};
    case Shape::TwoRows: return {join({arming, {gap}, flight}), {mode, gap, stop, gap, result}};
    case Shape::ThreeRows: break;
    }
    // The controls in the order of the other shapes, since the hand knows where they are.
    return {join({arming, {gap, result}}), flight, {mode, {nullptr, kGrid, 1}, stop}};
}

QString ActionBar::nameOf(int systemId, bool brief)
{
    return brief ? tr("veh. %1").arg(systemId) : tr("vehicle %1").arg(systemId);
}

int ActionBar::leastWidth(Shape shape) const
{
    int widest = 0;
    for (const std::vector<Piece> &row : rowsOf(shape)) {
        int width = 2 * kGrid + static_cast<int>(row.size() - 1) * kHalfGrid;
        for (const Piece &piece : row)
            width += piece.least;
        widest = std::max(widest, width);
    }
    return widest;
}

void ActionBar::arrange()
{
    Shape shape = Shape::ThreeRows;
    for (const Shape wider : {Shape::TwoRows, Shape::BriefRow, Shape::OneRow})
        if (width() >= leastWidth(wider))
            shape = wider;
    if (shape == m_shape)
        return;
    m_shape = shape;
    for (QHBoxLayout *row : m_rows)
        while (const QLayoutItem *item = row->takeAt(0))
            delete item;
    const bool narrow = shape == Shape::BriefRow, stacked = shape == Shape::OneRow || narrow;
    m_preArm->setOnTwoLines(narrow);
    m_mode->setStacked(stacked);
    m_stop->setStacked(stacked, narrow);
    for (const Target &target : m_targets) { // as high with one vehicle as among several, and whatever it does
        int height = kTargetHeight;
        for (const QString &text : {target.textIn(shape), target.armingTextIn(shape)})
            height = std::max(height, target.button->heightFor(belowEachOther(text, nameOf(kAnyVehicle, narrow))));
        target.button->setMinimumHeight(height);
    }
    const auto rows = rowsOf(shape);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const Piece &piece : rows[i]) {
            if (!piece.widget) {
                m_rows[i]->addSpacing(piece.least);
                if (piece.stretch > 0)
                    m_rows[i]->addStretch(piece.stretch);
                continue;
            }
            piece.widget->setMinimumWidth(piece.least);
            piece.widget->setMaximumWidth(piece.stretch == 0 ? piece.least : QWIDGETSIZE_MAX);
            m_rows[i]->addWidget(piece.widget, piece.stretch);
        }
    }
    showNames();
    layout()->invalidate();
    setFixedHeight(layout()->minimumSize().height());
    updateGeometry();
}

QSize ActionBar::minimumSizeHint() const
{
    return {leastWidth(Shape::ThreeRows), height()};
}

void ActionBar::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void ActionBar::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if ((event->type() != QEvent::FontChange && event->type() != QEvent::StyleChange) || !m_shape)
        return;
    const auto again = [this] {
        m_shape.reset();
        arrange();
    };
    again();
    QMetaObject::invokeMethod(this, again, Qt::QueuedConnection); // the widgets in it take over the change after this one
}

void ActionBar::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(0, 0, width(), 1, stateColors(palette()).line);
}

void ActionBar::showViewState(const ViewState &view)
{
    const bool present = view.vehicle != nullptr;
    const std::uint8_t systemId = present ? view.vehicle->state.systemId : 0;
    const bool another = systemId != m_systemId;
    if (another) {
        if (m_systemId != 0)
            say({}, true); // the result was that of another vehicle
        endHolds(holdButtons(), tr("another vehicle is selected"));
        m_stop->lock();
    }
    m_systemId = systemId;
    m_several = present && view.vehicles().size() > 1;
    const bool armed = present && view.vehicle->state.armed;
    if (armed != m_armed) {
        std::vector<HoldButton *> changed{m_arm};
        for (const Target &target : m_targets)
            if (!target.arming.text.isEmpty())
                changed.push_back(target.button);
        endHolds(changed, armed ? tr("the vehicle has been armed") : tr("the vehicle has been disarmed"));
    }
    m_armed = armed;
    static const vehicle::VehicleState kNothing;
    const vehicle::VehicleState &state = present ? view.vehicle->state : kNothing;
    m_mode->showModes(state.modes, state.mode, another);
    m_preArm->showViewState(view);
    for (Target &target : m_targets)
        target.arms = present && vehicle::armsFirst(target.command(), state);
    m_arm->setPurpose(present && !armed && vehicle::armingTakesOff(state)
                          ? tr("In its present mode the vehicle takes off as soon as it is armed.")
                          : QString());
    showNames();
    showPermits(view);
}

void ActionBar::endHolds(const std::vector<HoldButton *> &buttons, const QString &why)
{
    for (HoldButton *button : buttons) {
        if (!button->isHeld())
            continue;
        button->abort();
        say(tr("Not sent: %1").arg(why), false);
    }
}

void ActionBar::showNames()
{
    const int named = m_several ? m_systemId : 0;
    const bool brief = m_shape && isBrief(*m_shape);
    const auto name = [named, brief](HoldButton &button, const QString &text, const QString &word) {
        const QString line = named == 0 ? text : belowEachOther(text, nameOf(named, brief));
        button.setCommand(line, spokenCommand(word, named));
    };
    const QString arm = m_armed ? tr("Disarm") : tr("Arm");
    name(*m_arm, arm, arm);
    for (const Target &target : m_targets) {
        const Shape shape = m_shape.value_or(Shape::OneRow);
        name(*target.button, target.arms ? target.armingTextIn(shape) : target.textIn(shape),
             target.arms ? target.arming.spoken : target.word);
        target.button->setPurpose(target.arms ? target.arming.purpose : target.purpose);
    }
    m_mode->nameVehicle(named);
    m_stop->nameVehicle(named);
}

void ActionBar::showPermits(const ViewState &view)
{
    const QString reason = commandsDisabledReason(view);
    m_arm->setDisabledReason(m_armed ? actionDisabledReason(vehicle::Disarm{}, view) : nothingCanBeSent(reason));
    for (const Target &target : m_targets)
        target.button->setDisabledReason(actionDisabledReason(target.command(), view));
    m_altitude->setEnabled(reason.isEmpty());
    m_mode->setDisabledReason(nothingCanBeSent(reason));
    m_stop->setDisabledReason(actionDisabledReason(vehicle::Disarm{.force = true}, view));
    // Without a vehicle, the line stays empty.
    const QString line = view.vehicle ? nothingCanBeSent(reason) : QString();
    if (line == m_disabledReason)
        return;
    if (!line.isEmpty())
        say(line, false);
    else if (m_result->text() == m_disabledReason)
        say({}, true);
    m_disabledReason = line;
}

void ActionBar::setUnits(UnitSystem units)
{
    m_altitude->setUnits(units);
    m_shape.reset();
    arrange();
}

void ActionBar::say(const QString &line, bool ok)
{
    m_result->showResult(line);
    QPalette colors = palette();
    if (!ok)
        colors.setColor(QPalette::WindowText, stateColors(palette()).alarm);
    m_result->setPalette(colors);
}

} // namespace skyseal::ui

#include "moc_action_bar.cpp"
