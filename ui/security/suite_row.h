// One suite of the Secure link panel: a radio button that follows its action. A click does not check it, because only an agreed
// switch moves the mark. The arrow keys move the focus; Space or a click chooses. The reason of a disabled suite, which follows
// its name, is shortened to the width there is: the tool tip has all of it.
#pragma once

#include <QtWidgets/QRadioButton>

class QAction;

namespace skyseal::ui {

class SuiteRow : public QRadioButton
{
    Q_OBJECT

public:
    explicit SuiteRow(QAction &action, QWidget *parent = nullptr);

    /// Room for the name of the suite.
    QSize minimumSizeHint() const override;

protected:
    void nextCheckState() override {}
    void resizeEvent(QResizeEvent *event) override;

private:
    void refresh();
    void elide();
    /// Width of everything but the text.
    int frameWidth() const;

    QAction &m_action;
};

} // namespace skyseal::ui
