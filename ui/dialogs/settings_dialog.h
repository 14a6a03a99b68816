// The dialog of the settings, which are edited as one value. Insecure choices carry a warning and a check box of their own.
#pragma once

#include "ui/settings.h"

#include <QtWidgets/QDialog>

#include <bitset>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace skyseal::ui {

class SettingsDialog : public QDialog
{
    Q_OBJECT

public:
    explicit SettingsDialog(const Settings &settings, QWidget *parent = nullptr);

    /// System ids of vehicles, of which none can be chosen for the station: it could not be told from the vehicle.
    void setVehicles(const std::bitset<256> &systems);

    Settings settings() const;

private:
    QWidget *makeView();
    QWidget *makeStation();
    QWidget *makeSecurity();
    void offerWeakestSuites();
    void check();

    Settings m_start;
    QComboBox *m_language, *m_theme, *m_units, *m_coordinates;
    QSpinBox *m_systemId, *m_componentId;
    QLineEdit *m_link, *m_folder;
    QCheckBox *m_touch, *m_speak, *m_record, *m_research, *m_required;
    QComboBox *m_weakest;
    QLabel *m_idTaken;
    QPushButton *m_ok;
    std::bitset<256> m_vehicles;
};

} // namespace skyseal::ui
