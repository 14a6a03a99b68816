// The last result, with its time, in a place of fixed height, so that a long one moves nothing around it.
#pragma once

#include <QtCore/QTime>
#include <QtWidgets/QLabel>

namespace skyseal::ui {

/// Shows the time and a plain text on at most kLines lines; the rest is elided and stays in the tool tip. Lives on the GUI
/// thread.
class ResultLabel : public QLabel
{
    Q_OBJECT

public:
    static constexpr int kLines = 2;

    explicit ResultLabel(QWidget *parent = nullptr);

    /// A result of this moment; empty: there is none any more.
    void showResult(const QString &text);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    int heightForWidth(int) const override { return sizeHint().height(); }

protected:
    void paintEvent(QPaintEvent *) override;

private:
    QString m_time;
};

} // namespace skyseal::ui
