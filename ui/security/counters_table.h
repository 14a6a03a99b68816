// The counters of received records in both directions: counted here ("from vehicle") and reported by the agent ("to vehicle").
#pragma once

#include "core/channel/stats.h"

#include <QtWidgets/QWidget>

#include <vector>

class QLabel;

namespace skyseal::ui {

class FigureLabel;

class CountersTable : public QWidget
{
    Q_OBJECT

public:
    explicit CountersTable(QWidget *parent = nullptr);

    /// Shows dashes for null.
    void showStats(const channel::SessionStats *stats);
    /// The compact form shows all refused records in one row, the sum, with the parts in its tool tip.
    void setBrief(bool brief);
    bool isBrief() const { return m_brief; }
    int rowHeight() const;

private:
    struct Row
    {
        std::uint64_t channel::ReceiveCounters::*counter; ///< null: the sum of the refused records
        bool alarming;                                    ///< highlighted if not zero
        QLabel *name;
        FigureLabel *toUs;
        FigureLabel *toIt;
    };
    void showRow(const Row &row, const channel::SessionStats *stats);

    std::vector<Row> m_rows;
    bool m_brief = false;
};

} // namespace skyseal::ui
