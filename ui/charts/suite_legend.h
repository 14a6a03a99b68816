// The legend of the diagnostics: the suites in the picture by colour and name, and what the dotted lines are.
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
    QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent *) override;

private:
    std::vector<crypto::SuiteId> m_suites;
};

} // namespace skyseal::ui
