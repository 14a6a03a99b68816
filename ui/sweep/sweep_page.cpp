#include "ui/sweep/sweep_page.h"

#include "core/experiment/analysis.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/report_warnings.h"
#include "ui/control_action.h"
#include "ui/theme/form_pieces.h"
#include "ui/sweep/ratio_chart.h"
#include "ui/sweep/sweep_bars.h"
#include "ui/sweep/sweep_table_model.h"
#include "ui/sweep/sweep_labels.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QTimer>
#include <QtGui/QPainter>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QSplitter>
#include <QtWidgets/QTableView>

#include <algorithm>

namespace skyseal::ui {

namespace {

/// One line of text, elided where it is too long.
class SweepStatusLine : public QLabel
{
public:
    explicit SweepStatusLine(QWidget *parent) : QLabel(parent)
    {
        setTextFormat(Qt::PlainText);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setPen(palette().color(foregroundRole()));
        painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter, fontMetrics().elidedText(text(), Qt::ElideRight, width()));
    }
};

/// A note as a sentence of its own.
QString noteText(const Reason &note)
{
    QString out = reasonText(note);
    if (out.isEmpty())
        return out;
    out[0] = out[0].toUpper();
    return QStringLiteral(".?!…").contains(out.back()) ? out : out + QLatin1Char('.');
}

} // namespace

SweepPage::SweepPage(QWidget *parent)
    : QWidget(parent), m_status(named(new SweepStatusLine(this), "sweepStatus", tr("The sweep"))),
      m_notes(named(new QLabel(this), "sweepNotes", tr("Warnings and the measurement's own share"))),
      m_noteArea(named(new QScrollArea(this), "sweepNoteArea", tr("Warnings of the sweep"))),
      m_bar(named(new QProgressBar(this), "sweepProgress", tr("Runs completed"))),
      m_start(named(new QPushButton(tr("Run a sweep…"), this), "sweepStart", tr("Run a sweep"))),
      m_cancel(named(new QPushButton(tr("Cancel"), this), "sweepCancel", tr("Cancel the sweep"))),
      m_save(named(new QPushButton(tr("Save…"), this), "sweepSave", tr("Save the sweep's files"))),
      m_place(named(new QComboBox(this), "sweepPlace", tr("Load and link"))),
      m_shown(named(new QComboBox(this), "sweepShown", tr("Ratios or means"))),
      m_metric(named(new QComboBox(this), "sweepMetric", tr("Measurement in the bars"))), m_table(new QTableView(this)),
      m_model(new SweepTableModel(this)), m_bars(new SweepBars(this)), m_clock(new QTimer(this))
{
    m_bar->setMaximumWidth(20 * kGrid);
    m_bar->setTextVisible(false);
    for (QComboBox *choice : {m_place, m_shown, m_metric}) { // as wide as the widest choice, where there is room
        choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        choice->setMinimumContentsLength(12);
    }
    auto *top = new QHBoxLayout;
    top->setSpacing(kGrid);
    top->addStretch(1);
    for (QWidget *tool : std::initializer_list<QWidget *>{m_bar, m_place, m_shown, m_metric, m_cancel, m_save, m_start})
        top->addWidget(tool);

    named(m_table, "sweepTable", tr("Results of the sweep"))->setModel(m_model);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(kRow);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    auto *scroll = named(new QScrollArea(this), "sweepBarArea", tr("Bars of the sweep"));
    scroll->setWidget(m_bars);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto *body = new QSplitter(Qt::Horizontal, this);
    body->setObjectName(QStringLiteral("sweepBody"));
    body->addWidget(m_table);
    body->addWidget(scroll);
    body->setStretchFactor(0, 3);
    body->setStretchFactor(1, 2);
    body->setChildrenCollapsible(false);
    m_notes->setWordWrap(true);
    m_notes->setTextFormat(Qt::PlainText);
    m_notes->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_notes->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_noteArea->setWidget(m_notes);
    m_noteArea->setWidgetResizable(true);
    m_noteArea->setFrameShape(QFrame::NoFrame);
    m_noteArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_noteArea->hide();
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kHalfGrid);
    column->addLayout(top);
    column->addWidget(m_status);
    column->addWidget(m_noteArea);
    column->addWidget(body, 1);

    m_clock->setInterval(1000);
    connect(m_clock, &QTimer::timeout, this, [this] {
        m_progress.remaining = std::max(1.0, m_progress.remaining - 1);
        showStatus();
    });
    connect(m_start, &QPushButton::clicked, this, &SweepPage::runRequested);
    connect(m_cancel, &QPushButton::clicked, this, &SweepPage::cancelRequested);
    connect(m_save, &QPushButton::clicked, this, &SweepPage::saveRequested);
    connect(m_place, &QComboBox::currentIndexChanged, this, &SweepPage::showResults);
    connect(m_place, &QComboBox::activated, this, [this] { m_follows = false; });
    connect(m_shown, &QComboBox::currentIndexChanged, this, [this] {
        fillMetrics();
        showResults();
    });
    connect(m_metric, &QComboBox::currentIndexChanged, this, &SweepPage::showResults);
    connect(m_metric, &QComboBox::activated, this, [this] { m_wasChosen = true; });
    setStatus(tr("No sweep yet. A sweep measures the cost of each suite in turn."));
    showStatus();
    setPossible(false);
    addActions(
        {pressAction(*m_cancel, Qt::CTRL | Qt::SHIFT | Qt::Key_F9), pressAction(*m_save, Qt::CTRL | Qt::SHIFT | Qt::Key_F8)});
}

SweepPage::~SweepPage() = default;

void SweepPage::setPossible(bool possible)
{
    m_start->setEnabled(possible);
}

void SweepPage::begin(const experiment::Plan &plan)
{
    auto results = std::make_shared<experiment::Results>();
    results->plan = plan;
    m_results = std::move(results);
    m_running = true;
    m_stopping = false;
    m_run.reset();
    m_follows = true;
    m_progress = {0, experiment::schedule(plan).size(), 0};
    fillChoices();
    showResults();
    showStatus();
    m_clock->start();
}

void SweepPage::fillChoices()
{
    const QSignalBlocker quietPlace(m_place), quietShown(m_shown);
    const experiment::Plan &plan = m_results->plan;
    m_place->clear();
    for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
        for (std::size_t load = 0; load < plan.loads.size(); ++load) {
            m_place->addItem(placeText(plan, condition, load), QPoint(static_cast<int>(condition), static_cast<int>(load)));
        }
    }
    m_shown->clear();
    m_shown->addItem(ratiosText(plan));
    m_shown->addItem(tr("Means"));
    m_shown->setCurrentIndex(plan.launches * plan.repeats > 1 ? 0 : 1); // a ratio takes two runs of each
    fillMetrics();
    for (QComboBox *choice : {m_place, m_shown})
        choice->view()->setMinimumWidth(choice->view()->sizeHintForColumn(0) + 3 * kGrid);
}

void SweepPage::fillMetrics()
{
    const QSignalBlocker quiet(m_metric);
    const QVariant before = m_metric->currentData();
    m_metric->clear();
    for (const experiment::MetricInfo &info : experiment::metrics()) {
        if (!showsRatios())
            m_metric->addItem(metricText(info.metric), static_cast<int>(info.metric));
        else if (info.isShownIn(experiment::kDifferences) && !info.isShare() && !info.canBeNegative)
            m_metric->addItem(metricTitle(info.metric), static_cast<int>(info.metric));
    }
    const int cost = showsRatios() ? m_metric->findData(static_cast<int>(experiment::Metric::CpuPerFrame)) : 0;
    const int same = m_metric->findData(before);
    m_metric->setCurrentIndex(same >= 0 && m_wasChosen ? same : std::max(0, cost));
    m_metric->view()->setMinimumWidth(m_metric->view()->sizeHintForColumn(0) + 3 * kGrid);
}

bool SweepPage::showsRatios() const
{
    return m_shown->currentIndex() == 0;
}

void SweepPage::showRun(const experiment::Run &run, const SweepProgress &progress)
{
    m_run = run;
    m_progress = progress;
    showRunningPlace();
    showStatus();
}

void SweepPage::showRunningPlace()
{
    const auto at = QPoint(static_cast<int>(m_run->condition), static_cast<int>(m_run->load));
    if (const int index = m_place->findData(at); m_follows && index >= 0)
        m_place->setCurrentIndex(index);
}

void SweepPage::take(const experiment::Sample &sample, const SweepProgress &progress)
{
    auto results = std::make_shared<experiment::Results>(*m_results);
    results->samples.push_back(sample);
    m_results = std::move(results);
    m_progress = progress;
    showResults();
    showStatus();
}

void SweepPage::showStopping()
{
    m_stopping = true;
    showStatus();
}

void SweepPage::finish(std::shared_ptr<const experiment::Results> results, const QString &problem)
{
    m_running = m_stopping = false;
    m_clock->stop();
    m_results = std::move(results);
    showResults();
    showStatus();
    const std::size_t runs = m_results->samples.size();
    const auto hasFailed = [](const experiment::Sample &sample) { return !sample.problem.empty(); };
    const auto failed = std::ranges::count_if(m_results->samples, hasFailed);
    QString text = m_results->complete ? (runs == 1 ? tr("One run in %1") : tr("%1 runs in %2").arg(runs))
                                             .arg(aboutTime(m_results->seconds).section(QLatin1Char(' '), 1))
                                       : tr("Incomplete, %1 of %2 runs: %3").arg(runs).arg(m_progress.runs).arg(problem);
    if (const auto first = std::ranges::find_if(m_results->samples, hasFailed); failed > 0)
        text += tr("; %1 failed: %2").arg(failed).arg(reasonText(first->problem));
    const auto isInvalid = [](const experiment::Sample &sample) { return !sample.invalid.empty(); };
    const auto invalid = std::ranges::count_if(m_results->samples, isInvalid);
    if (const auto first = std::ranges::find_if(m_results->samples, isInvalid); invalid > 0)
        text += tr("; %1 not valid: %2").arg(invalid).arg(reasonText(first->invalid));
    setStatus(text, !m_results->complete || failed > 0 || invalid > 0);
}

void SweepPage::showSaving()
{
    m_save->setEnabled(false);
    setStatus(tr("Writing the files…"));
}

void SweepPage::showSaved(const QString &folder, bool written, const QString &problem)
{
    m_save->setEnabled(!m_running);
    if (!written)
        return setStatus(tr("Not saved: %1").arg(problem), true);
    setStatus(problem.isEmpty() ? tr("Saved in %1").arg(folder) : tr("Saved in %1; %2").arg(folder, problem));
}

void SweepPage::showResults()
{
    if (!m_results)
        return;
    const QPoint place = m_place->currentData().toPoint();
    const auto condition = static_cast<std::size_t>(place.x()), load = static_cast<std::size_t>(place.y());
    m_model->show(m_results, condition, load, showsRatios() ? SweepTableModel::Shown::Ratios : SweepTableModel::Shown::Means);
    spanRows();
    QStringList labels;
    for (const experiment::SweepArm &arm : m_results->plan.arms)
        labels << armText(arm);
    const auto metric = static_cast<experiment::Metric>(m_metric->currentData().toInt());
    experiment::BarChart chart = showsRatios() ? ratioChart(*m_results, condition, load, metric)
                                               : experiment::chartOf(*m_results, condition, load, metric);
    if (!showsRatios())
        chart.axis = metricText(metric, chart.unit).toStdString();
    const QString notMeasured = m_running ? tr("not measured yet") : tr("not measured");
    for (std::size_t i = 0; i < chart.bars.size(); ++i) {
        const experiment::SweepArm &arm = m_results->plan.arms[i];
        // The repeated arm is compared with its first one alone, in the report.
        const QString missing = showsRatios() && arm.again ? tr("not compared") : notMeasured;
        chart.bars[i].missing = (experiment::exists(arm) ? missing : notInFramingText()).toStdString();
    }
    m_bars->showChart(std::move(chart), labels);
    showNotes();
}

/// The sentences of the report's first page. While the sweep runs it is not complete yet, which is no warning.
void SweepPage::showNotes()
{
    std::vector<Reason> notes;
    if (!m_running)
        notes = experiment::reportWarnings(*m_results);
    else if (Reason disturbed = experiment::disturbedRuns(*m_results); !disturbed.empty())
        notes.push_back(std::move(disturbed));
    const bool isWarning = !notes.empty();
    if (Reason meter = experiment::meterText(*m_results); !meter.empty())
        notes.push_back(std::move(meter));
    QStringList lines;
    for (const Reason &note : notes)
        lines << noteText(note);
    m_notes->setText(lines.join(QLatin1Char('\n')));
    QPalette colors = palette();
    if (isWarning)
        colors.setColor(QPalette::WindowText, stateColors(colors).warning);
    m_notes->setPalette(colors);
    m_noteArea->setVisible(!lines.isEmpty());
    fitNotes();
}

/// As high as its text, up to a few lines; the rest is scrolled to, so that the results keep their place.
void SweepPage::fitNotes()
{
    constexpr int kMostLines = 4;
    const int least = m_notes->fontMetrics().lineSpacing() + kHalfGrid,
              most = kMostLines * m_notes->fontMetrics().lineSpacing();
    const int wanted = m_notes->heightForWidth(std::max(10 * kGrid, width() - 2 * kGrid));
    m_noteArea->setFixedHeight(std::clamp(wanted, least, std::max(least, most)));
}

void SweepPage::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitNotes();
}

/// Shows "not in this framing" once, not in every column.
void SweepPage::spanRows()
{
    m_table->clearSpans();
    const int columns = m_model->columnCount() - SweepTableModel::FixedColumns;
    for (int row = 0; row < m_model->rowCount() && columns > 1; ++row) {
        if (!experiment::exists(m_results->plan.arms[static_cast<std::size_t>(row)]))
            m_table->setSpan(row, SweepTableModel::FixedColumns, 1, columns);
    }
}

void SweepPage::showStatus()
{
    m_start->setVisible(!m_running);
    m_cancel->setVisible(m_running);
    m_cancel->setEnabled(!m_stopping);
    m_bar->setVisible(m_running);
    m_save->setVisible(!m_running && m_results && !m_results->samples.empty());
    m_save->setEnabled(true);
    m_place->setVisible(m_results && (m_place->count() > 1 || !m_results->plan.conditions.front().clean()));
    m_shown->setVisible(m_results != nullptr);
    m_metric->setVisible(m_results != nullptr);
    if (!m_running)
        return;
    m_bar->setMaximum(static_cast<int>(m_progress.runs));
    m_bar->setValue(static_cast<int>(m_progress.done));
    if (m_stopping)
        return setStatus(tr("Stopping: restoring the suite of the link…"));
    if (!m_run)
        return setStatus(tr("Starting…"));
    const experiment::Plan &plan = m_results->plan;
    setStatus(tr("Run %1 of %2, %3 left: %4, %5")
                  .arg(std::min(m_progress.done + 1, m_progress.runs))
                  .arg(m_progress.runs)
                  .arg(aboutTime(m_progress.remaining), armText(plan.arms[m_run->arm]),
                       placeText(plan, m_run->condition, m_run->load)));
}

void SweepPage::setStatus(const QString &text, bool problem)
{
    m_status->setText(text);
    m_status->setToolTip(text);
    QPalette colors = palette();
    if (problem)
        colors.setColor(QPalette::WindowText, stateColors(colors).warning);
    m_status->setPalette(colors);
}

} // namespace skyseal::ui

#include "moc_sweep_page.cpp"
