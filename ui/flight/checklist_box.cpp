#include "ui/flight/checklist_box.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/ask_file.h"
#include "ui/flight/preflight.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QFileInfo>
#include <QtCore/QSignalBlocker>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>

#include <algorithm>

namespace skyseal::ui {

ChecklistBox::ChecklistBox(Preflight &preflight, QWidget *parent)
    : QWidget(parent), m_preflight(preflight), m_title(named(new QLabel(this), "checklistTitle", {})),
      m_problems(named(new QLabel(this), "checklistProblems", {})),
      m_list(named(new QListWidget(this), "checklist", tr("Checklist"))),
      m_choose(named(new QPushButton(tr("Choose a file…"), this), "checklistChoose", tr("Choose the file of the checklist"))),
      m_remove(named(new QPushButton(tr("No checklist"), this), "checklistRemove", tr("Use no checklist for this vehicle")))
{
    m_title->setWordWrap(true);
    m_problems->setWordWrap(true);
    m_problems->setTextFormat(Qt::PlainText);
    m_list->setWordWrap(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (QPushButton *button : {m_choose, m_remove})
        button->setAutoDefault(false);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(kGrid);
    buttons->addWidget(m_choose);
    buttons->addWidget(m_remove);
    buttons->addStretch(1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid);
    column->addWidget(m_title);
    column->addWidget(m_list, 1);
    column->addWidget(m_problems);
    column->addLayout(buttons);
    connect(m_choose, &QPushButton::clicked, this, &ChecklistBox::choose);
    connect(m_remove, &QPushButton::clicked, this, [this] { m_preflight.setFile(m_systemId, {}); });
    connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem *item) {
        m_preflight.tick(m_systemId, item->data(Qt::UserRole).toString(), item->checkState() == Qt::Checked);
    });
    connect(&preflight, &Preflight::changed, this, &ChecklistBox::refresh);
    refresh();
}

void ChecklistBox::showViewState(const ViewState &view)
{
    const std::uint8_t systemId = view.vehicle && !view.isReplay() ? view.vehicle->state.systemId : 0;
    if (systemId != m_systemId) {
        m_systemId = systemId;
        m_preflight.reload(systemId); // it may have been edited
    }
    refresh();
}

// Another vehicle may be selected while the file dialog is open: the list is for the one that was shown when it opened.
void ChecklistBox::choose()
{
    const std::uint8_t systemId = m_systemId;
    askFile(*this,
            {.title = tr("Checklist of vehicle %1").arg(systemId),
             .kinds = tr("Text files (*.txt);;All files (*)"),
             .start = m_preflight.file(systemId)},
            [this, systemId](const QString &file) { m_preflight.setFile(systemId, file); });
}

void ChecklistBox::refresh()
{
    const QSignalBlocker quiet(m_list);
    const auto items = m_preflight.items(m_systemId);
    while (m_list->count() > static_cast<int>(items.size()))
        delete m_list->takeItem(m_list->count() - 1);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Preflight::Item &item = items[i];
        if (static_cast<int>(i) == m_list->count())
            m_list->addItem(QString());
        QListWidgetItem &row = *m_list->item(static_cast<int>(i));
        const bool byHand = item.condition.isEmpty();
        const QString text = byHand ? item.text
            : item.done             ? tr("%1 · automatic: %2").arg(item.text, item.condition)
                                    : tr("%1 · not yet: %2").arg(item.text, item.condition);
        if (row.text() != text)
            row.setText(text);
        row.setData(Qt::UserRole, item.text);
        row.setFlags(byHand ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable
                            : Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        row.setCheckState(item.done ? Qt::Checked : Qt::Unchecked);
    }
    const QString file = m_preflight.file(m_systemId);
    const auto done = std::ranges::count_if(items, &Preflight::Item::done);
    const QString name = QFileInfo(file).fileName();
    const QString title = m_systemId == 0 ? tr("No checklist without a vehicle.")
        : file.isEmpty()
        ? tr("No checklist for vehicle %1. A checklist is a text file; see Help → First steps.").arg(m_systemId)
        : items.empty() ? tr("Checklist %1 cannot be read").arg(name)
                        : tr("Checklist %1: %2 of %3 done").arg(name).arg(done).arg(items.size());
    if (m_title->text() != title)
        m_title->setText(title);
    QString problems = m_preflight.problems(m_systemId).join(QLatin1Char('\n'));
    if (m_problems->text() != problems)
        m_problems->setText(problems);
    m_problems->setVisible(!problems.isEmpty());
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, stateColors(palette()).warning);
    m_problems->setPalette(colors);
    m_list->setVisible(!items.empty());
    setSizePolicy(QSizePolicy::Preferred, items.empty() ? QSizePolicy::Maximum : QSizePolicy::Expanding);
    m_choose->setEnabled(m_systemId != 0);
    m_remove->setEnabled(!file.isEmpty());
}

} // namespace skyseal::ui

#include "moc_checklist_box.cpp"
