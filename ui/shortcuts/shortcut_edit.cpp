#include "ui/shortcuts/shortcut_edit.h"

#include <QtGui/QKeyEvent>

namespace skyseal::ui {

namespace {

bool isModifier(int key)
{
    return key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_Meta || key == Qt::Key_AltGr;
}

} // namespace

void ShortcutEdit::keyPressEvent(QKeyEvent *event)
{
    const bool isAlone = event->modifiers() == Qt::NoModifier;
    if (isAlone && event->key() == Qt::Key_Escape)
        return event->ignore(); // closes the dialog
    if (event->isAutoRepeat() || isModifier(event->key()))
        return event->accept();
    QKeySequence keys;
    if (!isAlone || (event->key() != Qt::Key_Backspace && event->key() != Qt::Key_Delete)) {
        QKeySequenceEdit::keyPressEvent(event); // knows which key of the layout Shift belongs to
        keys = keySequence().isEmpty() ? QKeySequence() : QKeySequence(keySequence()[0]);
        if (keys.isEmpty())
            return;
    }
    clear(); // ends what would wait for a second combination
    setKeySequence(keys);
    Q_EMIT pressed(keys);
}

} // namespace skyseal::ui

#include "moc_shortcut_edit.cpp"
