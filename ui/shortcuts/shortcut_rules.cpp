#include "ui/shortcuts/shortcut_rules.h"

#include "ui/held_keys.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <array>

namespace skyseal::ui {

namespace {

struct ShortcutRulesText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ShortcutRules)
};

bool isArrow(Qt::Key key)
{
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

bool isLetter(Qt::Key key)
{
    return key < Qt::Key_Escape && QChar(static_cast<char16_t>(key)).isLetter(); // special keys come from Escape on
}

/// Fields of text and lists use these.
bool editsText(const QKeySequence &keys)
{
    constexpr std::array kEdits{QKeySequence::Copy, QKeySequence::Cut,       QKeySequence::Paste, QKeySequence::Undo,
                                QKeySequence::Redo, QKeySequence::SelectAll, QKeySequence::Delete};
    return std::ranges::any_of(kEdits, [&](auto edit) { return QKeySequence::keyBindings(edit).contains(keys); });
}

QString reason(const QKeySequence &keys)
{
    const Qt::Key key = keys[0].key();
    const Qt::KeyboardModifiers held = keys[0].keyboardModifiers() & ~Qt::KeypadModifier;
    if (keys.count() > 1)
        return ShortcutRulesText::tr("it must be pressed at once.");
    if (key == Qt::Key_unknown || key == 0)
        return ShortcutRulesText::tr("this key is not known.");
    if (HeldKeys::isPressKey(key))
        return ShortcutRulesText::tr("Space and Enter press buttons.");
    if (key == Qt::Key_Tab || key == Qt::Key_Backtab)
        return ShortcutRulesText::tr("Tab moves between controls.");
    if (key == Qt::Key_Escape)
        return ShortcutRulesText::tr("Esc closes and cancels.");
    if (isArrow(key))
        return ShortcutRulesText::tr("the arrows move in the map, in lists and in texts.");
    if (held == Qt::AltModifier && isLetter(key))
        return ShortcutRulesText::tr("Alt with a letter opens menus and presses buttons.");
    if (held == Qt::ShiftModifier && key == Qt::Key_F10)
        return ShortcutRulesText::tr("it opens the menu at the pointer.");
    if (editsText(keys))
        return ShortcutRulesText::tr("it edits texts.");
    const bool isFunctionKey = key >= Qt::Key_F1 && key <= Qt::Key_F35;
    if (!isFunctionKey && !(held & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)))
        return ShortcutRulesText::tr("without Ctrl or Alt, texts, lists and the map need it. F1 to F35 are free.");
    return {};
}

} // namespace

QString shortcutRefusal(const QKeySequence &keys)
{
    if (keys.isEmpty())
        return {};
    const QString why = reason(keys);
    return why.isEmpty()
        ? QString()
        : ShortcutRulesText::tr("%1 cannot be a shortcut: %2").arg(keys.toString(QKeySequence::NativeText), why);
}

} // namespace skyseal::ui
