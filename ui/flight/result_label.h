// A text of unknown length in a place of fixed height, so that a long result moves nothing around it.
#pragma once

#include <QtWidgets/QLabel>

namespace skyseal::ui {

/// Shows plain text on at most kLines lines; the rest is elided and stays in the tool tip. Lives on the GUI thread.
class ResultLabel : public QLabel
{
    Q_OBJECT

public:
    static constexpr int kLines = 2;

    explicit ResultLabel(QWidget *parent = nullptr);

    void showResult(const QString &text);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    int heightForWidth(int) const override { return sizeHint().height(); }

protected:
    void paintEvent(QPaintEvent *) override;
};

} // namespace skyseal::ui
