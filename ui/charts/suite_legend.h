// The legend of the charts: the suites used so far by colour and name, in as many lines as needed.
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
    /// Returns the names in the order of the legend.
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
    /// Returns the place of each name for this width, and the height that is needed.
    std::vector<Entry> arranged(int width, int *height) const;

    std::vector<crypto::SuiteId> m_suites;
};

} // namespace skyseal::ui
