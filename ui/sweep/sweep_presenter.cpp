#include "ui/sweep/sweep_presenter.h"

#include "ui/ask_file.h"
#include "ui/confirm_box.h"
#include "ui/modeless.h"
#include "ui/security/suite_actions.h"
#include "ui/sweep/sweep_dialog.h"
#include "ui/sweep/sweep_page.h"

#include <QtCore/QDateTime>
#include <QtCore/QDir>

namespace skyseal::ui {

SweepPresenter::SweepPresenter(SweepInterface &port, SweepPage &page, SuiteActions &suites, QWidget &window)
    : QObject(&window), m_port(port), m_page(page), m_suites(suites), m_window(window)
{
    connect(&port, &SweepInterface::runBegan, &page, &SweepPage::showRun);
    connect(&port, &SweepInterface::runBegan, this, [this](const experiment::Run &run) { beginRun(run); });
    connect(&port, &SweepInterface::sampleTaken, &page, &SweepPage::take);
    connect(&port, &SweepInterface::saved, &page, &SweepPage::showSaved);
    connect(&port, &SweepInterface::finished, this,
            [this](const std::shared_ptr<const experiment::Results> &results, const QString &problem) {
                m_page.finish(results, problem);
                hold(false);
                Q_EMIT finished();
            });
    connect(&page, &SweepPage::runRequested, this, &SweepPresenter::dialogRequested);
    connect(&page, &SweepPage::cancelRequested, this, &SweepPresenter::cancel);
    connect(&page, &SweepPage::saveRequested, this, &SweepPresenter::askFolder);
}

bool SweepPresenter::isRunning() const
{
    return m_page.isRunning();
}

void SweepPresenter::ask(const ViewState &view, bool requireSealed)
{
    if (isRunning() || raiseOpen<SweepDialog>(m_window))
        return;
    auto *dialog = new SweepDialog({view, m_suites, requireSealed, m_port.ownProgramsDisabledReason()}, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { startOrAsk(dialog->order()); });
    showModeless(*dialog);
}

/// A sweep on the link of an armed vehicle may be meant, but not by Ctrl+R and Enter alone.
void SweepPresenter::startOrAsk(const SweepOrder &order)
{
    if (order.target != SweepTarget::Connected || !m_isArmed)
        return start(order);
    askToConfirm({.objectName = QStringLiteral("confirmSweep"),
                  .title = tr("Cipher sweep"),
                  .text = tr("The vehicle is armed. Measure on its link?"),
                  .details = tr("The sweep switches the suite of the link by which the vehicle is commanded before each run."),
                  .yes = tr("Measure"),
                  .icon = QMessageBox::Warning},
                 &m_window, this, [this, order] { start(order); });
}

void SweepPresenter::start(const SweepOrder &order)
{
    if (isRunning())
        return;
    m_page.begin(order.plan);
    m_arms = order.plan.arms;
    m_plainArm = m_inClear = false;
    hold(order.target == SweepTarget::Connected);
    Q_EMIT began();
    m_port.start(order);
}

void SweepPresenter::beginRun(const experiment::Run &run)
{
    m_plainArm = run.arm < m_arms.size() && m_arms[run.arm].suite == crypto::SuiteId::None;
    m_inClear = m_inClear || m_plainArm;
}

void SweepPresenter::mark(ViewState &view)
{
    m_inClear = m_plainArm || (m_inClear && !view.session);
    view.inSweep = m_holdsLink;
    m_isArmed = hasArmedVehicle(view);
    view.plainRun = m_holdsLink && m_inClear;
}

void SweepPresenter::hold(bool on)
{
    m_holdsLink = on;
    m_suites.setHeld(on);
}

void SweepPresenter::cancel()
{
    if (!isRunning())
        return;
    m_page.showStopping();
    m_port.cancel();
}

void SweepPresenter::askFolder()
{
    askFile(m_window,
            {.title = tr("Choose the folder in which the sweep's folder is created"), .use = FileQuestion::Use::Folder},
            [this](const QString &folder) { saveIn(folder); });
}

void SweepPresenter::saveIn(const QString &folder)
{
    if (!m_page.results())
        return;
    const QString name = QDateTime::currentDateTime().toString(QStringLiteral("'skyseal-sweep-'yyyyMMdd-HHmmss"));
    m_page.showSaving();
    m_port.save(*m_page.results(), QDir(folder).filePath(name));
}

} // namespace skyseal::ui

#include "moc_sweep_presenter.cpp"
