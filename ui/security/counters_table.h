// What became of the records, in both directions: counted here ("to us") and reported by the other end ("to it").
#pragma once

#include "core/channel/stats.h"

#include <QtWidgets/QWidget>

#include <vector>

namespace skyseal::ui {

class FigureLabel;

class CountersTable : public QWidget
{
    Q_OBJECT

public:
    explicit CountersTable(QWidget *parent = nullptr);

    /// Null shows dashes.
    void showStats(const channel::SessionStats *stats);

private:
    struct Row
    {
        std::uint64_t channel::ReceiveCounters::*counter;
        bool alarming; ///< anything but zero deserves a look
        FigureLabel *toUs;
        FigureLabel *toIt;
    };
    std::vector<Row> m_rows;
};

} // namespace skyseal::ui
