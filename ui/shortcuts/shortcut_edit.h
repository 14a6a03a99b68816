// A field for the keys of one shortcut, which shows and reports them as soon as they are pressed. Tab and Esc keep what they do
// in a dialog; Backspace and Delete clear the field.
#pragma once

#include <QtWidgets/QKeySequenceEdit>

namespace skyseal::ui {

class ShortcutEdit : public QKeySequenceEdit
{
    Q_OBJECT

public:
    using QKeySequenceEdit::QKeySequenceEdit;

Q_SIGNALS:
    /// One combination of keys was pressed; none after Backspace or Delete.
    void pressed(const QKeySequence &keys);

protected:
    void keyPressEvent(QKeyEvent *event) override;
};

} // namespace skyseal::ui
