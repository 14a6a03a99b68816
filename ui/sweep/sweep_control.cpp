#include "ui/sweep/sweep_control.h"

#include "ui/security/suite_actions.h"
#include "ui/sweep/sweep_dialog.h"
#include "ui/sweep/sweep_page.h"

#include <QtCore/QDateTime>
#include <QtCore/QDir>
#include <QtWidgets/QFileDialog>

namespace skyseal::ui {

SweepControl::SweepControl(SweepPort &port, SweepPage &page, SuiteActions &suites, QWidget &window)
    : QObject(&window), m_port(port), m_page(page), m_suites(suites), m_window(window)
{
    connect(&port, &SweepPort::runBegan, &page, &SweepPage::showRun);
    connect(&port, &SweepPort::runBegan, this,
            [this](const experiment::Run &run) { beginRun(run); });
    connect(&port, &SweepPort::sampleTaken, &page, &SweepPage::take);
    connect(&port, &SweepPort::saved, &page, &SweepPage::showSaved);
    connect(&port, &SweepPort::finished, this,
            [this](const std::shared_ptr<const experiment::Results> &results, const QString &problem) {
                m_page.finish(results, problem);
                hold(false);
                Q_EMIT finished();
            });
    connect(&page, &SweepPage::runWanted, this, &SweepControl::askWanted);
    connect(&page, &SweepPage::cancelWanted, this, &SweepControl::cancel);
    connect(&page, &SweepPage::saveWanted, this, &SweepControl::askFolder);
}

bool SweepControl::isRunning() const
{
    return m_page.isRunning();
}

void SweepControl::ask(const Scene &scene, bool requireSealed)
{
    if (isRunning())
        return;
    auto *dialog = new SweepDialog({scene, m_suites, requireSealed, m_port.whyNoOwnVehicle()}, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { start(dialog->order()); });
    dialog->open();
}

void SweepControl::start(const SweepOrder &order)
{
    if (isRunning())
        return;
    m_page.begin(order.plan);
    m_arms = order.plan.arms;
    m_plainArm = m_inClear = false;
    hold(!order.ownVehicle);
    Q_EMIT began();
    m_port.start(order);
}

void SweepControl::beginRun(const experiment::Run &run)
{
    m_plainArm = run.arm < m_arms.size() && m_arms[run.arm].suite == crypto::SuiteId::None;
    m_inClear = m_inClear || m_plainArm;
}

void SweepControl::mark(Scene &scene)
{
    m_inClear = m_plainArm || (m_inClear && !scene.session);
    scene.inSweep = m_holdsLink;
    scene.plainRun = m_holdsLink && m_inClear;
}

void SweepControl::hold(bool on)
{
    m_holdsLink = on;
    m_suites.setHeld(on);
}

void SweepControl::cancel()
{
    if (!isRunning())
        return;
    m_page.showStopping();
    m_port.cancel();
}

void SweepControl::askFolder()
{
    const QString folder = QFileDialog::getExistingDirectory(&m_window, tr("Choose where to make the folder of this sweep"));
    if (!folder.isEmpty())
        saveIn(folder);
}

void SweepControl::saveIn(const QString &folder)
{
    if (!m_page.results())
        return;
    const QString name = QDateTime::currentDateTime().toString(QStringLiteral("'skyseal-sweep-'yyyyMMdd-HHmmss"));
    m_page.showSaving();
    m_port.save(*m_page.results(), QDir(folder).filePath(name));
}

} // namespace skyseal::ui
