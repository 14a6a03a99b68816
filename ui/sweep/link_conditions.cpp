#include "ui/sweep/link_conditions.h"

#include "ui/theme/form_pieces.h"
#include "ui/sweep/sweep_labels.h"
#include "ui/theme/grid.h"

#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QSpinBox>

#include <algorithm>

namespace skyseal::ui {

using experiment::Condition;

namespace {

Condition conditionOf(const QString &text)
{
    return experiment::parseCondition(text.toStdString()).value_or(Condition{});
}

} // namespace

LinkConditions::LinkConditions(QWidget *parent) : QGroupBox(parent)
{
    auto *upper = new QHBoxLayout;
    upper->setSpacing(3 * kGrid);
    const auto add = [&](const char *objectName, const QString &title, const char *text) {
        const QString condition = QLatin1String(text);
        auto *box = named(new QCheckBox(title, this), objectName, QString(title).remove(QLatin1Char('&')));
        box->setToolTip(linkText(conditionOf(condition)));
        upper->addWidget(box);
        m_presets.push_back({condition, box});
    };
    add("sweepClean", tr("Clea&n"), "clean");
    // Delays that are typical of half-duplex telemetry radios.
    add("sweepRadio57600", tr("&57,600 baud radio"), "rate=57600,delay=20");
    add("sweepRadio115200", tr("&115,200 baud radio"), "rate=115200,delay=20");
    // Without cores of their own the programs saturate no clean link: they use up all cores together first.
    add("sweepLine921600", tr("&921,600 baud line"), "rate=921600");
    upper->addStretch(1);
    m_presets.front().box->setChecked(true);
    m_own = named(new QCheckBox(tr("&Other:"), this), "sweepOwnLink", tr("Another link"));
    auto *lower = new QHBoxLayout;
    lower->setSpacing(kGrid);
    lower->addWidget(m_own);
    addFields(*lower);
    lower->addStretch(1);
    auto *column = new QVBoxLayout(this);
    column->setSpacing(kHalfGrid);
    column->addLayout(upper);
    column->addLayout(lower);
    for (const Preset &preset : m_presets)
        connect(preset.box, &QCheckBox::toggled, this, &LinkConditions::changed);
    connect(m_own, &QCheckBox::toggled, this, &LinkConditions::changed);
    setDisabledReason({});
}

void LinkConditions::addFields(QHBoxLayout &row)
{
    m_loss = named(new QDoubleSpinBox(this), "sweepLoss", tr("Packets lost"));
    m_loss->setRange(0, 100);
    m_loss->setDecimals(1);
    m_loss->setValue(5);
    m_loss->setSuffix(tr(" %"));
    const auto number = [this](const char *name, const QString &accessible, int most, const QString &suffix) {
        auto *box = named(new QSpinBox(this), name, accessible);
        box->setRange(0, most);
        box->setSuffix(suffix);
        return box;
    };
    m_delay = number("sweepDelay", tr("Delay"), 60'000, tr(" ms"));
    m_jitter = number("sweepJitter", tr("Jitter: additional delay, up to this value"), 60'000, tr(" ms"));
    m_rate = number("sweepRate", tr("Line rate"), 10'000'000, tr(" baud"));
    m_rate->setSingleStep(9'600);
    m_rate->setGroupSeparatorShown(true);
    m_rate->setSpecialValueText(tr("no limit"));
    const auto place = [&](const QString &title, QWidget *field) {
        field->setToolTip(tr("In both directions"));
        field->setEnabled(false);
        connect(m_own, &QCheckBox::toggled, field, &QWidget::setEnabled);
        auto *label = new QLabel(title, this);
        label->setBuddy(field);
        row.addWidget(label);
        row.addWidget(field);
    };
    place(tr("&loss"), m_loss);
    place(tr("&delay"), m_delay);
    place(tr("&jitter"), m_jitter);
    place(tr("r&ate"), m_rate);
    connect(m_loss, &QDoubleSpinBox::valueChanged, this, &LinkConditions::changed);
    for (QSpinBox *box : {m_delay, m_jitter, m_rate})
        connect(box, &QSpinBox::valueChanged, this, &LinkConditions::changed);
}

void LinkConditions::setDisabledReason(const QString &reason)
{
    m_disabledReason = reason;
    setEnabled(reason.isEmpty());
    setTitle(reason.isEmpty() ? tr("Link between the agent and the station") : tr("Link · %1").arg(reason));
}

void LinkConditions::preferFillable(bool fillable)
{
    QCheckBox *clean = m_presets.front().box, *line = m_presets.back().box;
    QCheckBox *before = fillable ? clean : line, *after = fillable ? line : clean;
    const bool isOther = std::ranges::any_of(m_presets,
                                             [&](const Preset &one) { return one.box != before && one.box->isChecked(); });
    if (isOther || m_own->isChecked() || !before->isChecked())
        return; // chosen by the user
    before->setChecked(false);
    after->setChecked(true);
}

QString LinkConditions::ownText() const
{
    QStringList out;
    if (m_loss->value() > 0)
        out << QStringLiteral("loss=%1").arg(m_loss->value() / 100);
    if (m_delay->value() > 0)
        out << QStringLiteral("delay=%1").arg(m_delay->value());
    if (m_jitter->value() > 0)
        out << QStringLiteral("jitter=%1").arg(m_jitter->value());
    if (m_rate->value() > 0)
        out << QStringLiteral("rate=%1").arg(m_rate->value());
    return out.isEmpty() ? QStringLiteral("clean") : out.join(QLatin1Char(','));
}

std::vector<Condition> LinkConditions::conditions() const
{
    if (!m_disabledReason.isEmpty())
        return {Condition{}};
    std::vector<Condition> out;
    const auto add = [&out](const QString &text) {
        Condition wanted = conditionOf(text);
        const auto same = [&](const Condition &there) { return there.settings == wanted.settings; };
        if (std::ranges::none_of(out, same))
            out.push_back(std::move(wanted));
    };
    for (const Preset &preset : m_presets) {
        if (preset.box->isChecked())
            add(preset.text);
    }
    if (m_own->isChecked())
        add(ownText());
    return out;
}

} // namespace skyseal::ui

#include "moc_link_conditions.cpp"
