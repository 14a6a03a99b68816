// Stops the motors at once by a forced disarm, behind two guards: it must be unlocked first, and then be held for a second. It
// locks itself again.
#pragma once

#include "ui/flight/hold_button.h"

#include <QtCore/QTimer>
#include <QtWidgets/QWidget>

class QBoxLayout;
class QCheckBox;

namespace skyseal::ui {

class EmergencyStop : public QWidget
{
    Q_OBJECT

public:
    static constexpr int kUnlockedMs = 10'000;
    static constexpr int kStopHoldMs = 1000;

    explicit EmergencyStop(QWidget *parent = nullptr);

    /// Locks and disables it with this sentence as tool tip; permits it if the sentence is empty.
    void setDisabledReason(const QString &sentence);
    void lock();
    /// One below the other, or side by side; with the button's text on two lines.
    void setStacked(bool stacked, bool onTwoLines = false);
    /// Width in pixels, with the vehicle's number on the button.
    int leastWidth(bool stacked, bool onTwoLines = false) const;
    /// Names the vehicle on the button; 0: there is no other.
    void nameVehicle(int systemId);
    HoldButton &button() const { return *m_stop; }

Q_SIGNALS:
    void confirmed();

private:
    void showLock();
    static QString word(bool onTwoLines);

    QBoxLayout *m_box;
    QCheckBox *m_unlock;
    HoldButton *m_stop;
    QTimer m_relock{this};
    QString m_disabledReason;
    bool m_onTwoLines = false;
    int m_named = 0; ///< the vehicle on the button
};

} // namespace skyseal::ui
