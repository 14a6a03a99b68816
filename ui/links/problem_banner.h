// Banner at the top of the window for a problem that needs a decision, such as a link that could not be opened. One button
// applies the remedy, another closes the banner. Main thread.
#pragma once

#include <QtWidgets/QFrame>

#include <functional>

class QLabel;
class QPushButton;

namespace skyseal::ui {

class ProblemBanner : public QFrame
{
    Q_OBJECT

public:
    explicit ProblemBanner(QWidget *parent = nullptr);

    /// Shows `problem` in place of an earlier one. `remedy` is the text of the button that calls `act`; empty for no button.
    void notify(const QString &problem, const QString &remedy = {}, std::function<void()> act = {});
    QString problem() const;

private:
    QLabel *m_icon, *m_text;
    QPushButton *m_act;
    QPushButton *m_close;
    std::function<void()> m_remedy;
};

} // namespace skyseal::ui
