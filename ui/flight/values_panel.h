// The vehicle's values: two columns of name, value and dimmed unit. Stale values turn grey and show their age.
#pragma once

#include "ui/view_state.h"
#include "ui/text/figures.h"
#include "ui/text/units.h"

#include <QtWidgets/QWidget>

#include <array>

class QGridLayout;

namespace skyseal::ui {

class ValuesPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ValuesPanel(QWidget *parent = nullptr);

    void showViewState(const ViewState &view);
    void setUnits(UnitSystem units) { m_units = units; }

private:
    FigureLabel *addRow(QGridLayout *grid, int row, int column, const QString &name, const QString &objectName,
                        const QString &sample, const QString &sampleUnit);

    FigureLabel *m_altitude, *m_speed, *m_climb, *m_current, *m_ekf;
    FigureLabel *m_heading, *m_home, *m_time, *m_hdop, *m_throttle;
    QLabel *m_age;
    UnitSystem m_units = UnitSystem::Metric;
};

} // namespace skyseal::ui
