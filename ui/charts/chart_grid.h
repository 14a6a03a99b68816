// The shown charts in as many columns as the width allows; scrolls if they do not fit.
#pragma once

#include <QtWidgets/QScrollArea>

#include <vector>

class QGridLayout;

namespace skyseal::ui {

class ChartGrid : public QScrollArea
{
    Q_OBJECT

public:
    explicit ChartGrid(QWidget *parent = nullptr);

    /// The parent of every chart.
    QWidget *sheet() const { return widget(); }
    /// Shows these charts in their order and hides the previous ones.
    void setCharts(const std::vector<QWidget *> &charts);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void arrange();

    QGridLayout *m_grid;
    std::vector<QWidget *> m_charts;
    int m_columns = 0;
};

} // namespace skyseal::ui
