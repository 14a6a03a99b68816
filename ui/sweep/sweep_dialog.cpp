#include "ui/sweep/sweep_dialog.h"

#include "core/engine/station/session_snapshot.h"
#include "core/link/link_type.h"
#include "ui/form_scroll.h"
#include "ui/theme/form_pieces.h"
#include "ui/sweep/link_conditions.h"
#include "ui/sweep/sweep_labels.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QRandomGenerator>
#include <QtGui/QValidator>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QGroupBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QRadioButton>
#include <QtWidgets/QSpinBox>

namespace skyseal::ui {

using crypto::SuiteId;
using experiment::Load;

namespace {

constexpr double kBetweenRuns = 0.3; ///< seconds, approximate time of a switch

} // namespace

SweepDialog::SweepDialog(const SweepContext &context, QWidget *parent)
    : QDialog(parent), m_context(context), m_link(new LinkConditions(this)), m_warning(new QLabel(this)),
      m_summary(new QLabel(this)), m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this))
{
    setObjectName(QStringLiteral("sweepDialog"));
    setWindowTitle(tr("Run a sweep"));
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("&Run"));
    named(m_summary, "sweepSummary", tr("Summary"));
    named(m_warning, "sweepWarning", tr("Warning"))->setWordWrap(true);
    auto *groups = new QWidget(this);
    auto *inner = new QVBoxLayout(groups);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(kGrid);
    inner->addWidget(makeTargetGroup());
    inner->addWidget(m_link);
    inner->addWidget(makeArmsGroup());
    inner->addWidget(makeRunsGroup());
    inner->addStretch(1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addWidget(new FormScroll(groups), 1);
    column->addWidget(m_warning);
    column->addWidget(m_summary);
    column->addWidget(m_buttons);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_link, &LinkConditions::changed, this, &SweepDialog::updateSummary);
    m_warning->setMinimumWidth(72 * kGrid);
    updateChoices();
    fitToScreen(*this);
}

QWidget *SweepDialog::makeTargetGroup()
{
    auto *box = new QGroupBox(tr("Measure on"), this);
    m_connected = named(new QRadioButton(box), "sweepConnected", tr("The connected link"));
    m_own = named(new QRadioButton(tr("A separate simulated &vehicle, on this machine"), box), "sweepOwn",
                  tr("A separate simulated vehicle"));
    const QString notConnected = connectedLinkDisabledReason(m_context);
    const QString peer = m_context.view.session ? fromStd(m_context.view.session->info.peerName) : QString();
    m_connected->setText(notConnected.isEmpty() ? tr("The &connected link, to %1").arg(peer)
                                                : tr("The &connected link · %1").arg(notConnected));
    m_connected->setEnabled(notConnected.isEmpty());
    m_own->setEnabled(m_context.noOwnPrograms.isEmpty());
    m_beside = named(new QRadioButton(tr("A running &autopilot, with a separate agent"), box), "sweepBeside",
                     tr("A running autopilot"));
    m_beside->setEnabled(m_context.noOwnPrograms.isEmpty());
    m_autopilot = named(new QLineEdit(QStringLiteral("tcp:127.0.0.1:5760"), box), "sweepAutopilot",
                        tr("Link to the autopilot"));
    m_autopilot->setToolTip(fromStd(link::linkForms()));
    m_autopilot->setEnabled(false);
    if (!m_context.noOwnPrograms.isEmpty()) {
        for (QRadioButton *choice : {m_own, m_beside})
            choice->setText(choice->text() + QStringLiteral(" · ") + m_context.noOwnPrograms);
    }
    (m_connected->isEnabled() ? m_connected : m_own)->setChecked(true);
    auto *column = new QVBoxLayout(box);
    column->addWidget(m_connected);
    column->addWidget(smallPrint(tr("The suites change on the live link. At the end the current suite is restored."), box));
    column->addWidget(m_own);
    auto *beside = new QHBoxLayout;
    beside->addWidget(m_beside);
    beside->addWidget(m_autopilot, 1);
    column->addLayout(beside);
    column->addWidget(smallPrint(tr("Suites and impairments change on the sweep's own link; the autopilot is not commanded. "
                                    "Flights: skyseal-cli sweep --vehicle URL --fly SCRIPT."),
                                 box));
    for (QRadioButton *choice : {m_connected, m_own, m_beside})
        connect(choice, &QRadioButton::toggled, this, [this](bool on) {
            if (on)
                updateChoices();
        });
    connect(m_autopilot, &QLineEdit::textChanged, this, &SweepDialog::updateSummary);
    return box;
}

QWidget *SweepDialog::makeArmsGroup()
{
    auto *box = new QGroupBox(tr("Suites, framing and load"), this);
    auto *suites = new QVBoxLayout;
    suites->setSpacing(kHalfGrid);
    for (const SuiteId suite : crypto::sealedSuites())
        m_suites.push_back({suite, new QCheckBox(box)});
    m_suites.push_back({SuiteId::None, new QCheckBox(box)});
    for (const Choice &choice : m_suites) {
        const QString name = fromStd(crypto::suiteInfo(choice.suite).name);
        named(choice.box, "", suiteName(choice.suite))->setObjectName(QStringLiteral("sweep_") + name);
        choice.box->setIcon(suiteDot(choice.suite));
        connect(choice.box, &QCheckBox::toggled, this, &SweepDialog::updateSummary);
        suites->addWidget(choice.box);
    }
    m_sealed = named(new QCheckBox(tr("Sealed: whole frames in records"), box), "sweepSealed", tr("Sealed framing"));
    m_inline = named(new QCheckBox(box), "sweepInline", tr("Inline framing"));
    m_natural = named(new QCheckBox(tr("Natural load: the streams that a station requests"), box), "sweepNatural",
                      tr("Natural load"));
    m_saturated = named(new QCheckBox(box), "sweepSaturated", tr("Saturated load"));
    m_sealed->setChecked(true);
    m_natural->setChecked(true);
    auto *others = new QVBoxLayout;
    others->setSpacing(kHalfGrid);
    for (QCheckBox *choice : {m_sealed, m_inline}) {
        others->addWidget(choice);
        connect(choice, &QCheckBox::toggled, this, &SweepDialog::updateSummary);
    }
    others->addWidget(
        smallPrint(tr("Inline is the framing that the MAVSec paper measured: payloads are encrypted in place, headers "
                      "stay clear. It needs a cipher with an HMAC, and the agent must allow it (skyseal-air "
                      "--allow-inline)."),
                   box));
    others->addSpacing(kGrid);
    for (QCheckBox *choice : {m_natural, m_saturated}) {
        others->addWidget(choice);
        connect(choice, &QCheckBox::toggled, this, &SweepDialog::updateSummary);
    }
    others->addStretch(1);
    auto *row = new QHBoxLayout(box);
    row->setSpacing(3 * kGrid);
    row->addLayout(suites, 1);
    row->addLayout(others, 1);
    return box;
}

QWidget *SweepDialog::makeRunsGroup()
{
    auto *box = new QGroupBox(tr("Duration"), this);
    m_seconds = named(new QDoubleSpinBox(box), "sweepSeconds", tr("Length of each run"));
    m_seconds->setRange(0.5, 3600);
    m_seconds->setDecimals(1);
    m_seconds->setSuffix(tr(" s"));
    m_seconds->setValue(5);
    m_repeats = named(new QSpinBox(box), "sweepRepeats", tr("Runs for each suite"));
    m_repeats->setRange(1, 1000);
    m_repeats->setValue(3);
    constexpr quint32 kDrawnBelow = 1'000'000'000; // short enough to be typed again
    const QString drawn = QString::number(QRandomGenerator::system()->bounded(kDrawnBelow));
    m_seed = named(new QLineEdit(drawn, box), "sweepSeed", tr("Seed"));
    m_seed->setValidator(new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[0-9]{1,19}")), m_seed));
    m_seed->setToolTip(tr("The same seed gives the same order of runs"));
    m_noise = named(new QCheckBox(tr("One suite twice, to see the noise (A/A)"), box), "sweepNoise", tr("Measure the noise"));
    m_noise->setChecked(true);
    auto *left = new QFormLayout;
    left->setVerticalSpacing(kGrid);
    left->addRow(tr("&Each run"), m_seconds);
    left->addRow(tr("Re&peats"), m_repeats);
    auto *right = new QFormLayout;
    right->setVerticalSpacing(kGrid);
    right->addRow(tr("&Seed of the order"), m_seed);
    right->addRow(m_noise);
    auto *row = new QHBoxLayout(box);
    row->setSpacing(3 * kGrid);
    row->addLayout(left, 1);
    row->addLayout(right, 1);
    connect(m_seconds, &QDoubleSpinBox::valueChanged, this, &SweepDialog::updateSummary);
    connect(m_repeats, &QSpinBox::valueChanged, this, &SweepDialog::updateSummary);
    connect(m_seed, &QLineEdit::textChanged, this, &SweepDialog::updateSummary);
    connect(m_noise, &QCheckBox::toggled, this, &SweepDialog::updateSummary);
    return box;
}

SweepTarget SweepDialog::target() const
{
    return m_beside->isChecked() ? SweepTarget::Autopilot
        : m_own->isChecked()     ? SweepTarget::Simulated
                                 : SweepTarget::Connected;
}

std::optional<link::LinkUrl> SweepDialog::autopilot() const
{
    if (target() != SweepTarget::Autopilot)
        return std::nullopt;
    const auto url = link::LinkUrl::parse(m_autopilot->text().trimmed().toStdString(), link::LinkUrl::kLoopback);
    return url ? std::optional(*url) : std::nullopt;
}

void SweepDialog::permit(QCheckBox *box, const QString &text, const QString &reason)
{
    box->setEnabled(reason.isEmpty());
    // The remedy in brackets is shown only in the tool tip.
    const QString brief = reason.section(QStringLiteral(" ("), 0, 0);
    box->setText(reason.isEmpty() ? text : text + QStringLiteral(" · ") + brief);
    box->setToolTip(reason);
    if (!reason.isEmpty())
        box->setChecked(false);
}

/// Enables the choices that are possible; on the connected link, plain MAVLink must be chosen explicitly.
void SweepDialog::updateChoices()
{
    const SweepTarget now = target();
    m_autopilot->setEnabled(now == SweepTarget::Autopilot);
    for (const Choice &choice : m_suites) {
        const QString reason = suiteDisabledReason(m_context, now, choice.suite);
        permit(choice.box, suiteName(choice.suite), reason);
        choice.box->setChecked(reason.isEmpty() && (hasOwnAgent(now) || choice.suite != SuiteId::None));
    }
    permit(m_inline, tr("Inline: payloads sealed in place"), inlineDisabledReason(m_context, now));
    const QString notSaturated = saturatedDisabledReason(now);
    permit(m_saturated, notSaturated.isEmpty() ? tr("Saturated load: as much as the link carries") : tr("Saturated load"),
           notSaturated);
    m_saturated->setChecked(notSaturated.isEmpty());
    m_link->setDisabledReason(otherLinkDisabledReason(now));
    if (hasOwnAgent(now))
        m_link->preferFillable(now == SweepTarget::Simulated && !m_context.ownCores);
    updateSummary();
}

void SweepDialog::updateSummary()
{
    const bool repeats = m_repeats->value() > 1;
    m_noise->setEnabled(repeats);
    m_noise->setToolTip(repeats ? QString() : tr("The noise can be measured only with 2 or more repeats."));
    const experiment::Plan plan = order().plan;
    const std::size_t runs = experiment::schedule(plan).size();
    const bool hasLink = target() != SweepTarget::Autopilot || autopilot();
    const bool possible = runs > 0 && hasLink && (m_connected->isEnabled() || m_own->isEnabled());
    const double each = seconds(plan.measure) + seconds(plan.warmUp) + kBetweenRuns;
    // The first run of a block has four times the warm-up.
    const double first = 3 * seconds(plan.warmUp) * static_cast<double>(plan.loads.size() * plan.conditions.size());
    const QString time = aboutTime(static_cast<double>(runs) * each + first);
    m_summary->setText(possible       ? (runs == 1 ? tr("One run, %1").arg(time) : tr("%1 runs, %2").arg(runs).arg(time))
                           : !hasLink ? tr("The link to the autopilot must be a URL, such as tcp:127.0.0.1:5760.")
                                      : tr("Choose a link, a suite, a framing that the suite supports, and a load."));
    const bool plain = target() == SweepTarget::Connected && m_suites.back().box->isChecked();
    m_warning->setText(plain
                           ? tr("You consent to plain MAVLink: during these runs telemetry and commands are sent in clear, and "
                                "anyone can command the vehicle.")
                           : QString());
    m_warning->setVisible(plain);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(possible);
}

SweepOrder SweepDialog::order() const
{
    SweepOrder out;
    out.target = target();
    out.autopilot = autopilot();
    std::vector<SuiteId> suites;
    for (const Choice &choice : m_suites) {
        if (choice.box->isChecked())
            suites.push_back(choice.suite);
    }
    std::vector<experiment::ArmFraming> framings;
    if (m_sealed->isChecked())
        framings.push_back(experiment::ArmFraming::Sealed);
    if (m_inline->isChecked())
        framings.push_back(experiment::ArmFraming::Inline);
    experiment::Plan &plan = out.plan;
    plan.repeats = static_cast<unsigned>(m_repeats->value());
    plan.measure = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(m_seconds->value()));
    plan.seed = m_seed->text().toULongLong();
    plan.arms = experiment::armsOf(suites, framings, m_noise->isChecked() && plan.repeats > 1);
    plan.conditions = m_link->conditions();
    plan.loads.clear();
    if (m_natural->isChecked())
        plan.loads.push_back(Load::Natural);
    if (m_saturated->isChecked())
        plan.loads.push_back(Load::Saturated);
    return out;
}

} // namespace skyseal::ui

#include "moc_sweep_dialog.cpp"
