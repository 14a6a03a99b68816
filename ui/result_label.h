// The last result, with its time, in a place of fixed height, so that a long one moves nothing around it.
#pragma once

#include <QtCore/QTime>
#include <QtWidgets/QLabel>

namespace skyseal::ui {

/// Shows the time and a plain text on as many lines as its height has, kLines at least; the rest is elided and stays in the
/// tool tip. Its layout gives it the height of kLines, unless another vertical size policy is set. Lives on the GUI thread.
class ResultLabel : public QLabel
{
    Q_OBJECT

public:
    static constexpr int kLines = 2;

    explicit ResultLabel(QWidget *parent = nullptr);

    /// A result of this moment; empty: there is none any more.
    void showResult(const QString &text);

    /// The lines of the text as painted, the time before the first; the last one is elided if there is more.
    QStringList shownLines() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    int heightForWidth(int) const override { return sizeHint().height(); }

protected:
    void paintEvent(QPaintEvent *) override;

private:
    QString time() const; ///< as painted, with the space after it

    QString m_time;
};

} // namespace skyseal::ui
