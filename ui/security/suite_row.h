// One suite of the Secure link panel: a radio button that follows its action. A click does not check it, because only an agreed
// switch moves the mark. The arrow keys move the focus; Space or a click chooses.
#pragma once

#include <QtWidgets/QRadioButton>

class QAction;

namespace skyseal::ui {

class SuiteRow : public QRadioButton
{
    Q_OBJECT

public:
    explicit SuiteRow(QAction &action, QWidget *parent = nullptr);

protected:
    void nextCheckState() override {}

private:
    void refresh();

    QAction &m_action;
};

} // namespace skyseal::ui
