// The help pages that are built into the program.
#pragma once

#include <QtCore/QHash>
#include <QtWidgets/QDialog>

namespace skyseal::ui {

class HelpDialog : public QDialog
{
    Q_OBJECT

public:
    /// `page` is a name in resources/help without its suffix; the page of that name in the folder of the language is shown if
    /// there is one. Each line <!-- key --> of the page is replaced by the Markdown text `inserts` holds for that key.
    HelpDialog(const QString &page, const QHash<QString, QString> &inserts, QWidget *parent = nullptr);
};

} // namespace skyseal::ui
