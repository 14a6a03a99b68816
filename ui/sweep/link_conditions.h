// The choice of the links that a sweep measures on in turn: a clean link, radios of two line rates, a line that can be
// saturated on any machine, and one with custom impairments.
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

    /// Disables the choice: the title shows the reason and conditions() is the clean link. Empty: enables it.
    void setDisabledReason(const QString &reason);
    /// Ticks the line that any machine fills in place of the clean link, or the reverse, if the other of the two is all that is
    /// ticked.
    void preferFillable(bool fillable);
    /// Empty if nothing is chosen.
    std::vector<experiment::Condition> conditions() const;

Q_SIGNALS:
    void changed();

private:
    /// In the syntax of `skyseal-cli sweep --impair`; "clean" if nothing is set.
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
    QString m_disabledReason;
};

} // namespace skyseal::ui
