// The dialog of the settings, which are edited as one value. Insecure choices carry a warning and a check box of their own.
#pragma once

#include "ui/settings.h"

#include <QtWidgets/QDialog>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QSpinBox;

namespace skyseal::ui {

class SettingsDialog : public QDialog
{
    Q_OBJECT

public:
    explicit SettingsDialog(const Settings &settings, QWidget *parent = nullptr);

    Settings settings() const;

private:
    QWidget *makeView();
    QWidget *makeStation();
    QWidget *makeSecurity();
    void offerWeakestSuites();

    Settings m_start;
    QComboBox *m_language, *m_theme, *m_units, *m_coordinates;
    QSpinBox *m_systemId, *m_componentId;
    QLineEdit *m_link, *m_folder;
    QCheckBox *m_touch, *m_speak, *m_record, *m_research, *m_required;
    QComboBox *m_weakest;
};

} // namespace skyseal::ui
