// The links that a sweep measures on, one after the other: a clean one, radios of two line rates, and one of the operator's
// own making. Each chosen one is measured whole.
#pragma once

#include "core/experiment/plan.h"

#include <QtWidgets/QGroupBox>

#include <vector>

class QCheckBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QSpinBox;

namespace skyseal::ui {

class LinkConditions : public QGroupBox
{
    Q_OBJECT

public:
    explicit LinkConditions(QWidget *parent = nullptr);

    /// The link cannot be changed: the title says why, and conditions() is the clean one alone. Empty: it can be chosen.
    void setWhyNot(const QString &reason);
    /// None when nothing is chosen.
    std::vector<experiment::Condition> conditions() const;

Q_SIGNALS:
    void changed();

private:
    /// As `skyseal-cli sweep --impair` takes it; "clean" when nothing is set.
    QString ownText() const;
    void addFields(QHBoxLayout &row);

    struct Preset
    {
        QString text;
        QCheckBox *box = nullptr;
    };

    std::vector<Preset> m_presets;
    QCheckBox *m_own;
    QDoubleSpinBox *m_loss;
    QSpinBox *m_delay, *m_jitter, *m_rate;
    QString m_whyNot;
};

} // namespace skyseal::ui
