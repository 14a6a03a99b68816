// Asks the operator once whether to do something that cannot be taken back. Cancel is the default; Esc and closing the box mean
// no, and a key that is down when the box opens does not answer it.
#pragma once

#include <QtWidgets/QMessageBox>

#include <functional>

namespace skyseal::ui {

struct Question
{
    QString objectName;
    QString title;
    QString text;
    QString details = {}; ///< smaller, below the text
    QString yes;          ///< text of the button that confirms: the verb
    QMessageBox::Icon icon = QMessageBox::Question;
};

/// Opens the box over `parent` and returns it; it deletes itself when it closes. `confirmed` is called if the operator confirms
/// while `context` exists. There is one question of an object name over `parent`: an open one closes as if the answer were no,
/// because the newest is what the operator wants.
QMessageBox *askToConfirm(const Question &question, QWidget *parent, QObject *context, std::function<void()> confirmed);

/// The open question of this object name over `parent`; null if there is none.
QMessageBox *openQuestion(const QWidget &parent, const QString &objectName);

} // namespace skyseal::ui
