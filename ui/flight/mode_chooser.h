// Offers the flight modes of the vehicle, follows the one in use unless the operator has selected another, and sets the
// selected one when its button is held.
#pragma once

#include "ui/flight/hold_button.h"

#include <QtWidgets/QWidget>

#include <string>
#include <vector>

class QBoxLayout;
class QComboBox;

namespace skyseal::ui {

class ModeChooser : public QWidget
{
    Q_OBJECT

public:
    explicit ModeChooser(QWidget *parent = nullptr);

    /// `current`: the mode in use; a mode that the operator selected for another vehicle is forgotten.
    void showModes(const std::vector<std::string> &modes, const std::string &current, bool anotherVehicle);
    /// Why nothing can be sent, in a sentence; empty: it can.
    void setDisabledReason(const QString &sentence);
    /// One below the other, or side by side.
    void setStacked(bool stacked);
    /// Width in pixels for any mode, with the vehicle's number on the button.
    int leastWidth(bool stacked) const;
    /// Names the vehicle on the button; 0: there is no other.
    void nameVehicle(int systemId);
    HoldButton &button() const { return *m_set; }

Q_SIGNALS:
    void confirmed(const QString &mode);
    /// The modes are about to change, which ends a hold.
    void modesChanging();

private:
    QBoxLayout *m_box;
    QComboBox *m_modes;
    HoldButton *m_set;
    std::vector<std::string> m_known;
    bool m_edited = false; ///< the selected mode is the operator's choice, which the vehicle is not in
};

} // namespace skyseal::ui
