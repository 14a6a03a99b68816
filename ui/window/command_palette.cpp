#include "ui/window/command_palette.h"

#include "ui/list_keys.h"
#include "ui/modeless.h"
#include "ui/text/menu_text.h"
#include "ui/text/plain_tip.h"
#include "ui/theme/grid.h"
#include "ui/window/window_actions.h"

#include <QtGui/QAction>
#include <QtGui/QKeyEvent>
#include <QtGui/QStandardItemModel>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMainWindow>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QTreeView>
#include <QtWidgets/QVBoxLayout>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr int kPaletteWidth = 100 * kGrid, kPaletteHeight = 44 * kGrid;

} // namespace

void CommandPalette::open(QMainWindow &window, WindowActions &others)
{
    if (raiseOpen<CommandPalette>(window))
        return;
    auto *palette = new CommandPalette(window, others);
    palette->move(window.mapToGlobal(QPoint((window.width() - kPaletteWidth) / 2, window.height() / 8)));
    showModeless(*palette);
}

CommandPalette::CommandPalette(QMainWindow &window, WindowActions &others) : QDialog(&window)
{
    setObjectName(QStringLiteral("commandPalette"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Find a command"));
    resize(kPaletteWidth, kPaletteHeight);
    m_typed = new QLineEdit(this);
    m_typed->setObjectName(QStringLiteral("paletteTyped"));
    m_typed->setPlaceholderText(tr("Parts of a name, such as \"rtl\" or \"map source\""));
    m_typed->setAccessibleName(tr("Command"));
    m_typed->setClearButtonEnabled(true);
    m_typed->installEventFilter(this);
    m_model = new QStandardItemModel(0, 2, this);
    m_list = new QTreeView(this);
    m_list->setObjectName(QStringLiteral("paletteList"));
    m_list->setAccessibleName(tr("Commands"));
    m_list->setModel(m_model);
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setFocusPolicy(Qt::NoFocus); // the arrows move the selection while one types
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::Fixed);
    m_none = new QLabel(tr("No command matches"), m_list);
    m_none->setObjectName(QStringLiteral("paletteNone"));
    m_none->setForegroundRole(QPalette::PlaceholderText);
    m_none->hide();
    auto *middle = new QVBoxLayout(m_list);
    middle->addWidget(m_none, 0, Qt::AlignCenter);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
    column->setSpacing(kGrid);
    column->addWidget(m_typed);
    column->addWidget(m_list, 1);

    for (QAction *top : window.menuBar()->actions())
        if (QMenu *menu = top->menu())
            collect(*menu, withoutMnemonic(top->text()));
    for (const WindowActions::Group &group : others.groups())
        for (const auto &action : group.actions)
            if (action)
                collect(*action, group.title);
    // A long reason must not take the room of the name; its tip says all of it.
    m_list->resizeColumnToContents(1);
    m_list->header()->resizeSection(1, std::min(m_list->header()->sectionSize(1), kPaletteWidth / 2));
    filter({});
    m_typed->setFocus();
    connect(m_typed, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(m_list, &QTreeView::clicked, this, [this](const QModelIndex &at) {
        if (at.row() == m_list->currentIndex().row()) // not so for an entry that is disabled
            choose();
    });
}

/// Menus fill themselves and learn what is possible when they are about to be shown.
void CommandPalette::collect(QMenu &menu, const QString &path)
{
    Q_EMIT menu.aboutToShow();
    for (QAction *action : menu.actions())
        collect(*action, path);
}

void CommandPalette::collect(QAction &action, const QString &path)
{
    if (action.isSeparator() || !action.isVisible())
        return;
    const QString name = path + QStringLiteral(" › ") + withoutMnemonic(action.text());
    if (QMenu *submenu = action.menu(); submenu && action.isEnabled())
        collect(*submenu, name);
    else
        add(action, name);
}

void CommandPalette::add(QAction &action, const QString &path)
{
    auto *name = new QStandardItem(path);
    const QString reason = action.isEnabled() ? QString() : action.statusTip();
    auto *note = new QStandardItem(reason.isEmpty() ? action.shortcut().toString(QKeySequence::NativeText) : reason);
    note->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (QStandardItem *item : {name, note}) {
        item->setEnabled(action.isEnabled());
        item->setToolTip(plainTip(reason.isEmpty() ? path : reason));
    }
    m_model->appendRow({name, note});
    m_actions.emplace_back(&action);
}

/// Shows the rows that contain every typed word, and selects the first one that is possible.
void CommandPalette::filter(const QString &typed)
{
    QModelIndex first;
    bool any = false;
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const bool matches = containsWords(m_model->item(row)->text(), typed);
        m_list->setRowHidden(row, {}, !matches);
        any = any || matches;
        if (matches && !first.isValid() && m_model->item(row)->isEnabled())
            first = m_model->index(row, 0);
    }
    m_list->setCurrentIndex(first);
    m_list->scrollTo(first);
    m_none->setVisible(!any);
}

void CommandPalette::choose()
{
    const QModelIndex current = m_list->currentIndex();
    if (!current.isValid())
        return;
    const QPointer<QAction> action = m_actions[static_cast<std::size_t>(current.row())];
    close();
    if (action)
        action->trigger();
}

bool CommandPalette::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_typed || event->type() != QEvent::KeyPress)
        return QDialog::eventFilter(watched, event);
    return takeListKey(*static_cast<QKeyEvent *>(event), *m_list, [this] { choose(); }) || QDialog::eventFilter(watched, event);
}

} // namespace skyseal::ui

#include "moc_command_palette.cpp"
