// The tool row above the charts: legend, view, group, time range, freeze and save.
#pragma once

#include "ui/charts/quantities.h"

class QCheckBox;
class QComboBox;
class QToolButton;

namespace skyseal::ui {

class ChartRange;
class SuiteLegend;

/// The views of the samples, and the results of a sweep.
enum class DiagnosticsView : std::uint8_t { TimeLine, Overlay, Table, Sweep };

class DiagnosticsTools : public QWidget
{
    Q_OBJECT

public:
    explicit DiagnosticsTools(QWidget *parent = nullptr);

    SuiteLegend *legend() const { return m_legend; }
    DiagnosticsView view() const;
    void setView(DiagnosticsView view);
    const QuantityGroup &group() const;
    /// Shows span and freeze of the charts without emitting signals.
    void showRange(const ChartRange &range);

Q_SIGNALS:
    void viewChanged();
    void groupChanged();
    void spanChosen(double seconds);
    /// To the next shorter range if positive, to the next longer one if negative.
    void spanStepped(int steps);
    void freezeChosen(bool frozen);
    void csvRequested();
    void pictureRequested();

private:
    QComboBox *addChoice(const char *objectName, const QString &accessible);

    std::vector<QuantityGroup> m_groups;
    SuiteLegend *m_legend;
    QComboBox *m_view, *m_group, *m_span;
    QCheckBox *m_freeze;
    QToolButton *m_save;
};

} // namespace skyseal::ui
