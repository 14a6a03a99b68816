#include "ui/shortcuts/shortcut_dialog.h"

#include "ui/confirm_box.h"
#include "ui/list_keys.h"
#include "ui/shortcuts/shortcut_edit.h"
#include "ui/shortcuts/shortcut_model.h"
#include "ui/shortcuts/shortcut_rules.h"
#include "ui/shortcuts/shortcuts.h"
#include "ui/text/menu_text.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>
#include <QtWidgets/QVBoxLayout>

#include <utility>

namespace skyseal::ui {

ShortcutDialog::ShortcutDialog(Shortcuts &shortcuts, QWidget *parent)
    : QDialog(parent), m_shortcuts(shortcuts), m_model(new ShortcutModel(shortcuts, this)),
      m_find(named(new QLineEdit(this), "shortcutFind", tr("Find an action"))),
      m_view(named(new QTreeView(this), "shortcutView", tr("Actions and their shortcuts"))), m_of(new QLabel(this)),
      m_note(named(new QLabel(this), "shortcutNote", tr("Result"))),
      m_keys(named(new ShortcutEdit(this), "shortcutKeys", tr("Shortcut of the selected action"))),
      m_replace(named(new QPushButton(tr("Re&place"), this), "shortcutReplace", tr("Take the shortcut from the other action"))),
      m_none(named(new QPushButton(tr("&None"), this), "shortcutNone", tr("Remove the shortcut of the selected action"))),
      m_reset(named(new QPushButton(tr("&Default"), this), "shortcutReset", tr("Default shortcut for the selected action")))
{
    setObjectName(QStringLiteral("shortcutDialog"));
    setWindowTitle(tr("Keyboard shortcuts"));
    m_find->setPlaceholderText(tr("Parts of a name, a menu or keys, such as \"zoom\" or \"ctrl+k\""));
    m_find->setClearButtonEnabled(true);
    m_find->installEventFilter(this);
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAllColumnsShowFocus(true);
    m_view->header()->setStretchLastSection(false);
    m_view->header()->setSectionResizeMode(ShortcutModel::Action, QHeaderView::Stretch);
    const QFontMetrics metrics(font());
    m_view->header()->setSectionResizeMode(ShortcutModel::Menu, QHeaderView::ResizeToContents);
    for (const auto column : {ShortcutModel::Keys, ShortcutModel::First}) // no key widens them
        m_view->header()->resizeSection(column, metrics.horizontalAdvance(QStringLiteral("Ctrl+Alt+Shift+F12")) + 3 * kGrid);
    m_note->setTextFormat(Qt::PlainText);
    m_note->setWordWrap(true);
    m_note->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_note->setMinimumHeight(2 * metrics.lineSpacing()); // what is below does not move

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addWidget(m_find);
    column->addWidget(m_view, 1);
    column->addWidget(m_of);
    column->addLayout(makeKeys());
    column->addWidget(m_note);
    column->addLayout(makeButtons());
    resize(104 * kGrid, 68 * kGrid);

    connect(m_find, &QLineEdit::textChanged, this, &ShortcutDialog::filter);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &ShortcutDialog::showRow);
    connect(m_view, &QTreeView::activated, m_keys, [this] { m_keys->setFocus(Qt::OtherFocusReason); });
    filter({});
    m_find->setFocus();
}

QLayout *ShortcutDialog::makeKeys()
{
    m_of->setTextFormat(Qt::PlainText);
    m_of->setBuddy(m_keys);
    auto *line = new QHBoxLayout;
    line->setSpacing(kGrid);
    line->addWidget(m_keys, 1);
    for (QPushButton *button : {m_replace, m_none, m_reset}) {
        button->setAutoDefault(false);
        line->addWidget(button);
    }
    connect(m_keys, &ShortcutEdit::pressed, this, &ShortcutDialog::request);
    connect(m_replace, &QPushButton::clicked, this, [this] { assign(m_requested); });
    connect(m_none, &QPushButton::clicked, this, [this] { assign({}); });
    connect(m_reset, &QPushButton::clicked, this,
            [this] { request(m_shortcuts.items()[static_cast<std::size_t>(row())].first); });
    return line;
}

QLayout *ShortcutDialog::makeButtons()
{
    auto *resetAll = named(new QPushButton(tr("Reset &all…"), this), "shortcutResetAll", tr("Reset all shortcuts"));
    auto *close = named(new QPushButton(tr("Close"), this), "shortcutClose", tr("Close"));
    resetAll->setAutoDefault(false);
    close->setAutoDefault(false); // Enter in the list goes to the keys
    connect(resetAll, &QPushButton::clicked, this, &ShortcutDialog::askResetAll);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    auto *row = new QHBoxLayout;
    row->addWidget(resetAll);
    row->addStretch(1);
    row->addWidget(close);
    return row;
}

int ShortcutDialog::row() const
{
    const QModelIndex current = m_view->currentIndex();
    return current.isValid() && !m_view->isRowHidden(current.row(), {}) ? current.row() : -1;
}

/// Shows the rows that contain every typed word, and selects the first one if the selected one is not among them.
void ShortcutDialog::filter(const QString &typed)
{
    QModelIndex first;
    for (int i = 0; i < m_model->rowCount(); ++i) {
        const bool matches = containsWords(m_model->rowText(i), typed);
        m_view->setRowHidden(i, {}, !matches);
        if (matches && !first.isValid())
            first = m_model->index(i, 0);
    }
    if (row() < 0)
        m_view->setCurrentIndex(first);
    m_view->scrollTo(m_view->currentIndex());
    showRow();
}

void ShortcutDialog::showRow()
{
    const int shown = row();
    const bool any = shown >= 0;
    m_requested = {};
    m_note->clear();
    m_replace->setEnabled(false);
    m_keys->setEnabled(any);
    m_keys->setKeySequence(any ? m_shortcuts.keys(shown) : QKeySequence());
    m_none->setEnabled(any && !m_shortcuts.keys(shown).isEmpty());
    m_reset->setEnabled(any && m_shortcuts.keys(shown) != m_shortcuts.items()[static_cast<std::size_t>(shown)].first);
    m_of->setText(any ? tr("Shortcut of \"%1\": press the keys, or Backspace for none").arg(m_shortcuts.name(shown))
                      : tr("No action has these words."));
}

/// Gives the selected action these keys if no other one has them; else says which would lose them.
void ShortcutDialog::request(const QKeySequence &keys)
{
    const QString refusal = shortcutRefusal(keys);
    const int owner = m_shortcuts.ownerOf(keys);
    if (refusal.isEmpty() && (owner < 0 || owner == row()))
        return assign(keys);
    showRow();
    if (!refusal.isEmpty())
        return m_note->setText(refusal);
    m_requested = keys;
    m_keys->setKeySequence(keys);
    m_replace->setEnabled(true);
    m_note->setText(
        tr("%1 is that of \"%2\"; it would lose it.").arg(keys.toString(QKeySequence::NativeText), m_shortcuts.name(owner)));
}

void ShortcutDialog::assign(const QKeySequence &keys)
{
    m_shortcuts.choose(row(), keys);
    showRow();
    const QString name = m_shortcuts.name(row());
    m_note->setText(keys.isEmpty() ? tr("\"%1\" has no shortcut now.").arg(name)
                                   : tr("%1 is now that of \"%2\".").arg(keys.toString(QKeySequence::NativeText), name));
}

void ShortcutDialog::askResetAll()
{
    askToConfirm({.objectName = QStringLiteral("confirmResetShortcuts"),
                  .title = tr("Reset all shortcuts"),
                  .text = tr("Give every action its default shortcut?"),
                  .yes = tr("Reset all")},
                 this, this, [this] {
                     m_shortcuts.resetAll();
                     showRow();
                     m_note->setText(tr("Every action has its default shortcut."));
                 });
}

bool ShortcutDialog::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_find || event->type() != QEvent::KeyPress)
        return QDialog::eventFilter(watched, event);
    return takeListKey(*static_cast<QKeyEvent *>(event), *m_view, [this] { m_keys->setFocus(Qt::OtherFocusReason); })
        || QDialog::eventFilter(watched, event);
}

} // namespace skyseal::ui

#include "moc_shortcut_dialog.cpp"
