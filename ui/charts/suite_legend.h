// The legend of the diagnostics: the suites used so far by colour and name, in as many lines as they need.
#pragma once

#include "core/crypto/suite.h"

#include <QtWidgets/QWidget>

#include <vector>

namespace skyseal::ui {

class SuiteLegend : public QWidget
{
    Q_OBJECT

public:
    explicit SuiteLegend(QWidget *parent = nullptr);

    void setSuites(const std::vector<crypto::SuiteId> &suites);
    /// The names in the picture, in their order.
    QStringList names() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent *) override;

private:
    struct Entry
    {
        crypto::SuiteId suite{};
        QString name;
        QPointF at; ///< left end, top of its line
    };
    /// Where each name stands in a legend of this width; the height that takes.
    std::vector<Entry> arranged(int width, int *height) const;

    std::vector<crypto::SuiteId> m_suites;
};

} // namespace skyseal::ui
