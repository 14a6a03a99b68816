// The help pages that come with the program.
#pragma once

#include <QtWidgets/QDialog>

namespace skyseal::ui {

class HelpDialog : public QDialog
{
    Q_OBJECT

public:
    /// `page` is a name in resources/help, without suffix.
    explicit HelpDialog(const QString &page, QWidget *parent = nullptr);
};

} // namespace skyseal::ui
