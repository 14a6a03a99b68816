// The alerts over the upper right corner of the map: the first five, one line each, and the number of the others. While the
// pointer or the focus is in it, no line moves: new ones are appended below, and a line that has gone leaves its place empty.
// It is as large as its lines, so that the wheel and clicks beside them reach the map. Lives on the GUI thread.
#pragma once

#include "ui/alerts/alert.h"

#include <QtCore/QPointer>
#include <QtWidgets/QFrame>

#include <array>
#include <optional>
#include <vector>

class QLabel;
class QToolButton;

namespace skyseal::ui {

class AlertRow;

class AlertStack : public QFrame
{
    Q_OBJECT

public:
    static constexpr int kMostShown = 5;

    /// Lies over `ground`, beside which it becomes a child of its parent.
    explicit AlertStack(QWidget &ground);

    /// Shows these, the most important ones first. `now` in seconds on the clock of the alerts.
    void showAlerts(std::vector<Alert> alerts, double now);
    /// Moves the focus to the first alert, until Esc or the end of the alerts returns it.
    void focusFirst();

Q_SIGNALS:
    void dismissed(skyseal::ui::AlertId id);
    /// The button that deals with it was pressed.
    void remedyRequested(skyseal::ui::AlertId id);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void paintEvent(QPaintEvent *) override;

private:
    /// True while no line may move.
    bool isHeld() const;
    bool hasInnerFocus() const;
    int mostShown() const;
    /// Chooses which alert stands on which line.
    void arrange();
    void fill();
    void place();
    void showMore(int hidden);
    void dismissRow(int row);
    void moveFocus(int from, int step);
    void returnFocus();
    int focusedRow() const;
    bool isDismiss(const QToolButton &button) const;

    QWidget &m_ground;
    std::vector<Alert> m_alerts;
    double m_now = 0;
    std::vector<std::optional<AlertId>> m_lines; ///< nullopt: its alert has gone
    std::array<AlertRow *, kMostShown> m_rows{};
    QLabel *m_more;
    bool m_pointerInside = false;
    QPointer<QWidget> m_focusBefore;
};

} // namespace skyseal::ui
