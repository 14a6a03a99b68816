// What became of the records, in both directions: counted here ("to us") and reported by the other end ("to it").
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

    /// Null shows dashes.
    void showStats(const channel::SessionStats *stats);
    /// Where there is little room all that was refused is one row, the sum; its tool tip tells the parts.
    void setBrief(bool brief);
    bool isBrief() const { return m_brief; }
    int rowHeight() const;

private:
    struct Row
    {
        std::uint64_t channel::ReceiveCounters::*counter; ///< null: the sum of what was refused
        bool alarming;                                    ///< anything but zero deserves a look
        QLabel *name;
        FigureLabel *toUs;
        FigureLabel *toIt;
    };
    void showRow(const Row &row, const channel::SessionStats *stats);

    std::vector<Row> m_rows;
    bool m_brief = false;
};

} // namespace skyseal::ui
