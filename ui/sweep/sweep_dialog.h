// The dialog that configures a sweep: target, links, suites, framings, load, duration and repeats. Disabled choices show the
// reason.
#pragma once

#include "ui/sweep/sweep_permits.h"
#include "ui/sweep/sweep_interface.h"

#include <QtWidgets/QDialog>

#include <vector>

class QCheckBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QRadioButton;
class QSpinBox;

namespace skyseal::ui {

class LinkConditions;

class SweepDialog : public QDialog
{
    Q_OBJECT

public:
    /// `context` must outlive it.
    SweepDialog(const SweepContext &context, QWidget *parent = nullptr);

    SweepOrder order() const;

private:
    struct Choice
    {
        crypto::SuiteId suite{};
        QCheckBox *box = nullptr;
    };

    QWidget *makeTargetGroup();
    QWidget *makeArmsGroup();
    QWidget *makeRunsGroup();
    void updateChoices();
    void updateSummary();
    SweepTarget target() const;
    /// nullopt: what is typed is no URL of a link, or the autopilot is not the target.
    std::optional<link::LinkUrl> autopilot() const;
    static void permit(QCheckBox *box, const QString &text, const QString &reason);

    SweepContext m_context;
    LinkConditions *m_link;
    QRadioButton *m_connected, *m_own, *m_beside;
    QLineEdit *m_autopilot;
    std::vector<Choice> m_suites;
    QCheckBox *m_sealed, *m_inline, *m_natural, *m_saturated, *m_noise;
    QDoubleSpinBox *m_seconds;
    QSpinBox *m_repeats;
    QLineEdit *m_seed;
    QLabel *m_warning, *m_summary;
    QDialogButtonBox *m_buttons;
};

} // namespace skyseal::ui
