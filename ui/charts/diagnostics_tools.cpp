#include "ui/charts/diagnostics_tools.h"

#include "ui/charts/chart_range.h"
#include "ui/charts/suite_legend.h"
#include "ui/control_action.h"
#include "ui/text/units.h"
#include "ui/theme/grid.h"

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>

namespace skyseal::ui {

namespace {

QString spanText(double seconds)
{
    return seconds < 120 ? DiagnosticsTools::tr("%1 s").arg(number(seconds, 0))
                         : DiagnosticsTools::tr("%1 min").arg(number(seconds / 60, 0));
}

} // namespace

DiagnosticsTools::DiagnosticsTools(QWidget *parent) : QWidget(parent), m_groups(quantityGroups())
{
    m_legend = new SuiteLegend(this);
    m_view = addChoice("chartView", tr("View of the measurements"));
    m_view->addItems({tr("Over time"), tr("Suites overlaid"), tr("Table"), tr("Sweep")});
    m_view->setToolTip(tr("Over time; all suites on one axis, by time in use; means as numbers; or the results of "
                          "a sweep"));
    m_group = addChoice("chartGroup", tr("Quantities shown"));
    for (const QuantityGroup &group : m_groups)
        m_group->addItem(group.title);
    m_span = addChoice("chartSpan", tr("Time range"));
    for (const double seconds : ChartRange::kSpans)
        m_span->addItem(spanText(seconds), seconds);
    m_freeze = new QCheckBox(tr("Freeze"), this);
    m_freeze->setObjectName(QStringLiteral("chartFreeze"));
    m_freeze->setAccessibleName(tr("Freeze the charts"));
    m_freeze->setToolTip(tr("Freezes the charts, not the measurement (Space). Drag over a chart or turn the wheel to zoom; "
                            "a double click, Home or Esc returns to live."));
    m_save = new QToolButton(this);
    m_save->setText(tr("Save"));
    m_save->setObjectName(QStringLiteral("chartSave"));
    m_save->setAccessibleName(tr("Save the measurements"));
    m_save->setPopupMode(QToolButton::InstantPopup);
    m_save->setFocusPolicy(Qt::StrongFocus);
    auto *menu = new QMenu(m_save);
    QAction *csv = menu->addAction(tr("Samples shown, as &CSV…"), this, &DiagnosticsTools::csvRequested);
    csv->setObjectName(QStringLiteral("chartCsv"));
    csv->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_F11);
    QAction *picture = menu->addAction(tr("&Picture as PNG or SVG…"), this, &DiagnosticsTools::pictureRequested);
    picture->setObjectName(QStringLiteral("chartPicture"));
    picture->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_F12);
    m_save->setMenu(menu);

    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGrid);
    row->addWidget(m_legend, 1);
    for (QWidget *tool : std::initializer_list<QWidget *>{m_view, m_group, m_span, m_freeze, m_save})
        row->addWidget(tool, 0, Qt::AlignTop);

    connect(m_view, &QComboBox::currentIndexChanged, this, [this, csv, picture] {
        for (QWidget *tool : std::initializer_list<QWidget *>{m_legend, m_group, m_span, m_freeze, m_save})
            tool->setEnabled(view() != DiagnosticsView::Sweep); // the page of the sweep has its own tools
        for (QAction *save : {csv, picture}) {
            save->setEnabled(m_save->isEnabled());
            save->setStatusTip(m_save->isEnabled() ? QString() : tr("The view \"Sweep\" is shown"));
        }
        Q_EMIT viewChanged();
    });
    connect(m_group, &QComboBox::currentIndexChanged, this, &DiagnosticsTools::groupChanged);
    connect(m_span, &QComboBox::activated, this, [this] { Q_EMIT spanChosen(m_span->currentData().toDouble()); });
    connect(m_freeze, &QCheckBox::toggled, this, &DiagnosticsTools::freezeChosen);
    const auto stepSpan = [this](const char *id, const QString &text, const QKeySequence &keys, int steps) {
        return new ControlAction(*m_span, QLatin1String(id), text, keys, [this, steps] { Q_EMIT spanStepped(steps); });
    };
    addActions({pressAction(*m_freeze, Qt::CTRL | Qt::Key_F9),
                stepSpan("chartShorter", tr("Shorter time range"), Qt::CTRL | Qt::Key_F10, 1),
                stepSpan("chartLonger", tr("Longer time range"), Qt::CTRL | Qt::Key_F11, -1),
                focusAction(*m_view, tr("Choose the view"), Qt::CTRL | Qt::Key_B),
                focusAction(*m_group, tr("Choose the quantities"), Qt::ALT | Qt::SHIFT | Qt::Key_Q), csv, picture});
}

QComboBox *DiagnosticsTools::addChoice(const char *objectName, const QString &accessible)
{
    auto *box = new QComboBox(this);
    box->setObjectName(QLatin1String(objectName));
    box->setAccessibleName(accessible);
    return box;
}

DiagnosticsView DiagnosticsTools::view() const
{
    return static_cast<DiagnosticsView>(m_view->currentIndex());
}

void DiagnosticsTools::setView(DiagnosticsView view)
{
    m_view->setCurrentIndex(static_cast<int>(view));
}

const QuantityGroup &DiagnosticsTools::group() const
{
    return m_groups[static_cast<std::size_t>(m_group->currentIndex())];
}

void DiagnosticsTools::showRange(const ChartRange &range)
{
    const QSignalBlocker quietSpan(m_span), quietFreeze(m_freeze);
    m_span->setCurrentIndex(m_span->findData(range.span()));
    if (m_span->currentIndex() < 0)
        m_span->setPlaceholderText(spanText(range.span()));
    m_freeze->setChecked(range.frozen());
}

} // namespace skyseal::ui

#include "moc_diagnostics_tools.cpp"
