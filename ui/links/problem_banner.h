// A line across the top of the window for a problem that needs an answer: a link that could not be opened, a demo program
// that ended. One button does what can be done about it, another closes it.
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

    /// `remedy` is the button's text, empty for none. The newest problem replaces an older one.
    void notify(const QString &problem, const QString &remedy = {}, std::function<void()> act = {});
    QString problem() const;

private:
    QLabel *m_icon, *m_text;
    QPushButton *m_act;
    QPushButton *m_close;
    std::function<void()> m_remedy;
};

} // namespace skyseal::ui
