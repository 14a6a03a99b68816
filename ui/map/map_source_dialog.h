// The dialog in which the operator chooses where the pictures of the map come from, and is told what a tile server learns.
#pragma once

#include "ui/settings.h"

#include <QtWidgets/QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;
class QSpinBox;

namespace skyseal::ui {

class MapSourceDialog : public QDialog
{
    Q_OBJECT

public:
    explicit MapSourceDialog(const MapSource &source, QWidget *parent = nullptr);

    MapSource source() const;

private:
    QWidget *makeServer();
    QWidget *makeFile();
    void browse();
    /// Enables what belongs to the choice, and OK if it is complete.
    void refresh();
    QString problem() const;

    MapSource m_start;
    QRadioButton *m_none, *m_server, *m_file;
    QWidget *m_serverForm, *m_fileForm;
    QLineEdit *m_url, *m_attribution, *m_path;
    QSpinBox *m_deepest;
    QLabel *m_state;
    QPushButton *m_ok;
};

} // namespace skyseal::ui
