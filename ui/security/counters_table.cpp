#include "ui/security/counters_table.h"

#include "ui/text/figures.h"
#include "ui/text/units.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QGridLayout>

namespace skyseal::ui {

CountersTable::CountersTable(QWidget *parent) : QWidget(parent)
{
    using channel::ReceiveCounters;
    struct Entry
    {
        QString name, tip;
        std::uint64_t ReceiveCounters::*counter;
        bool alarming;
    };
    const Entry entries[] = {
        {tr("good"), tr("Records with a valid authentication tag"), &ReceiveCounters::good, false},
        {tr("late"), tr("Valid, but received after a newer record"), &ReceiveCounters::late, false},
        {tr("lost"), tr("Sent, but not received"), &ReceiveCounters::lost, false},
        {tr("replayed"), tr("Received before, refused"), &ReceiveCounters::replayed, true},
        {tr("forged"), tr("Authentication tag invalid, refused"), &ReceiveCounters::forged, true},
        {tr("malformed"), tr("Not a valid record, refused"), &ReceiveCounters::malformed, true},
        {tr("plain"), tr("Plain MAVLink that claims to come from a sealed peer, refused"), &ReceiveCounters::plaintextDropped,
         true},
        {tr("stale"), tr("Valid, but too late to command or to be shown"), &ReceiveCounters::stale, true},
        {tr("refused"), {}, nullptr, true},
    };
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kGrid);
    grid->setVerticalSpacing(2);
    int column = 1;
    for (const QString &head : {tr("from vehicle"), tr("to vehicle")}) {
        auto *label = new QLabel(head, this);
        label->setForegroundRole(QPalette::PlaceholderText);
        grid->addWidget(label, 0, column++, Qt::AlignRight);
    }
    int row = 1;
    for (const Entry &entry : entries) {
        auto *name = new QLabel(entry.name, this);
        name->setForegroundRole(QPalette::PlaceholderText);
        name->setToolTip(entry.tip);
        grid->addWidget(name, row, 0);
        Row cells{entry.counter, entry.alarming, name, new FigureLabel(this), new FigureLabel(this)};
        int at = 1;
        for (FigureLabel *cell : {cells.toUs, cells.toIt}) {
            cell->setSample(QStringLiteral("8 888 888"), {});
            cell->setAccessibleName(tr("%1 %2").arg(entry.name, at == 1 ? tr("from vehicle") : tr("to vehicle")));
            cell->setObjectName(QStringLiteral("counter_%1_%2").arg(row).arg(at));
            cell->setToolTip(entry.tip);
            grid->addWidget(cell, row, at++);
        }
        m_rows.push_back(cells);
        ++row;
    }
    grid->setColumnStretch(0, 1);
    showStats(nullptr);
    m_brief = true;
    setBrief(false);
}

void CountersTable::setBrief(bool brief)
{
    if (brief == m_brief)
        return;
    m_brief = brief;
    for (const Row &row : m_rows) {
        const bool sum = row.counter == nullptr;
        for (QWidget *part : std::initializer_list<QWidget *>{row.name, row.toUs, row.toIt})
            part->setVisible(sum ? brief : !(brief && row.alarming));
    }
}

int CountersTable::rowHeight() const
{
    return m_rows.front().name->sizeHint().height() + static_cast<QGridLayout *>(layout())->verticalSpacing();
}

void CountersTable::showStats(const channel::SessionStats *stats)
{
    for (const Row &row : m_rows)
        showRow(row, stats);
}

void CountersTable::showRow(const Row &row, const channel::SessionStats *stats)
{
    const QColor alarm = stateColors(palette()).alarm;
    const auto put = [&](FigureLabel *label, bool known, const channel::ReceiveCounters &counters) {
        const std::uint64_t value = row.counter
            ? counters.*row.counter
            : counters.replayed + counters.forged + counters.malformed + counters.plaintextDropped;
        label->setFigure(known ? grouped(value) : dash());
        label->setColor(known && row.alarming && value > 0 ? alarm : QColor());
        if (!row.counter)
            label->setToolTip(tr("%1 replayed, %2 forged, %3 malformed, %4 plain")
                                  .arg(grouped(counters.replayed), grouped(counters.forged), grouped(counters.malformed),
                                       grouped(counters.plaintextDropped)));
    };
    static const channel::SessionStats kNone;
    put(row.toUs, stats != nullptr, stats ? stats->rx : kNone.rx);
    put(row.toIt, stats && stats->peerReported, stats ? stats->peerRx : kNone.peerRx);
}

} // namespace skyseal::ui

#include "moc_counters_table.cpp"
