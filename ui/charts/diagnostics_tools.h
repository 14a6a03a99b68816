// The row above the diagnostics: the legend, what is shown and how, stop and save.
#pragma once

#include "ui/charts/quantities.h"

class QCheckBox;
class QComboBox;
class QToolButton;

namespace skyseal::ui {

class ChartRange;
class SuiteLegend;

/// How the same samples are looked at, or what a sweep brought.
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
    /// Span and freeze as the charts have them; says nothing back.
    void showRange(const ChartRange &range);

Q_SIGNALS:
    void viewChanged();
    void groupChanged();
    void spanChosen(double seconds);
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
