// The bar below the map that commands the vehicle: arming with the state of its checks, the flight actions as large targets,
// the mode, the emergency stop, and the result of the last command. Buttons are held to confirm. The arrangement depends on the
// bar's width alone, so that nothing moves while flying.
#pragma once

#include "ui/flight/hold_button.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/text/units.h"
#include "ui/view_state.h"

#include <QtWidgets/QWidget>

#include <array>
#include <functional>
#include <optional>
#include <vector>

class QHBoxLayout;

namespace skyseal::ui {

class AltitudeBox;
class EmergencyStop;
class ModeChooser;
class PreArmButton;
class ResultLabel;

class ActionBar : public QWidget
{
    Q_OBJECT

public:
    static constexpr int kTargetHeight = 44; ///< pixels, the least of a flight action

    explicit ActionBar(VehicleCommands &commands, QWidget *parent = nullptr);

    void showViewState(const ViewState &view);
    void setUnits(UnitSystem units);
    void say(const QString &line, bool ok);

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override { return minimumSizeHint(); }

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    /// BriefRow: one row with texts on two lines, as on a screen of 1366 pixels.
    enum class Shape : std::uint8_t { OneRow, BriefRow, TwoRows, ThreeRows };
    static bool isBrief(Shape shape) { return shape == Shape::BriefRow || shape == Shape::ThreeRows; }
    /// A flight action.
    struct Target
    {
        /// What stands on it while it arms the vehicle first; empty: it never does.
        struct Arming
        {
            QString text, briefText; ///< on two lines
            QString spoken, purpose;
        };

        HoldButton *button;
        QString word;
        bool breaks; ///< its words stand below each other in a BriefRow
        std::function<vehicle::VehicleCommand()> command;
        QString purpose = {};
        Arming arming = {};
        bool arms = false; ///< at present

        QString textIn(Shape shape) const;
        QString armingTextIn(Shape shape) const { return isBrief(shape) ? arming.briefText : arming.text; }
    };
    /// A widget in a row, or a gap if there is none.
    struct Piece
    {
        QWidget *widget;
        int least; ///< width in pixels
        int stretch = 0;
    };

    void addTarget(const char *objectName, const QString &word, std::function<vehicle::VehicleCommand()> command,
                   bool breaks = false);
    std::vector<std::vector<Piece>> rowsOf(Shape shape) const;
    int leastWidth(Shape shape) const;
    void arrange();
    /// The last line of a button that names the vehicle.
    static QString nameOf(int systemId, bool brief);
    std::vector<HoldButton *> holdButtons() const;
    /// Aborts holds whose meaning has changed.
    void endHolds(const std::vector<HoldButton *> &buttons, const QString &why);
    void showNames();
    void showPermits(const ViewState &view);

    VehicleCommands &m_commands;
    HoldButton *m_arm;
    PreArmButton *m_preArm;
    AltitudeBox *m_altitude;
    std::vector<Target> m_targets;
    ModeChooser *m_mode;
    EmergencyStop *m_stop;
    ResultLabel *m_result;
    std::array<QHBoxLayout *, 3> m_rows{};
    std::optional<Shape> m_shape;
    QString m_disabledReason; ///< reason why commands cannot be sent, as shown in the result line
    std::uint8_t m_systemId = 0;
    bool m_armed = false, m_several = false;
};

} // namespace skyseal::ui
