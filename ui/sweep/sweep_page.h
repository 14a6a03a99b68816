// The page of a sweep in the diagnostics: progress, and the results so far as table and bars.
#pragma once

#include "ui/sweep/sweep_interface.h"

#include <QtWidgets/QWidget>

#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QTableView;
class QTimer;

namespace skyseal::ui {

class SweepBars;
class SweepTableModel;

class SweepPage : public QWidget
{
    Q_OBJECT

public:
    explicit SweepPage(QWidget *parent = nullptr);
    ~SweepPage() override;

    /// Clears the previous results for a new sweep.
    void begin(const experiment::Plan &plan);
    void showRun(const experiment::Run &run, const SweepProgress &progress);
    void take(const experiment::Sample &sample, const SweepProgress &progress);
    void showStopping();
    void finish(std::shared_ptr<const experiment::Results> results, const QString &problem);
    /// Shows the result of saving the files.
    void showSaved(const QString &folder, bool written, const QString &problem);
    void showSaving();
    /// Enables the button that starts a sweep.
    void setPossible(bool possible);

    bool isRunning() const { return m_running; }
    /// Complete after finish().
    std::shared_ptr<const experiment::Results> results() const { return m_results; }

Q_SIGNALS:
    void runRequested();
    void cancelRequested();
    void saveRequested();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void fillChoices();
    void fillMetrics();
    bool showsRatios() const;
    void showRunningPlace();
    void spanRows();
    void showResults();
    void showNotes();
    void fitNotes();
    void showStatus();
    void setStatus(const QString &text, bool problem = false);

    std::shared_ptr<const experiment::Results> m_results;
    bool m_running = false, m_stopping = false;
    bool m_follows = true;    ///< shows the link and load being measured until the operator selects another
    bool m_wasChosen = false; ///< the operator selected the metric of the bars
    std::optional<experiment::Run> m_run;
    SweepProgress m_progress;
    QLabel *m_status;
    QLabel *m_notes; ///< what a reader must know before the figures
    QScrollArea *m_noteArea;
    QProgressBar *m_bar;
    QPushButton *m_start, *m_cancel, *m_save;
    QComboBox *m_place, *m_shown, *m_metric;
    QTableView *m_table;
    SweepTableModel *m_model;
    SweepBars *m_bars;
    QTimer *m_clock; ///< updates the remaining time
};

} // namespace skyseal::ui
