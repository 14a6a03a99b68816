#include "ui/security/suite_row.h"

#include <QtGui/QAction>

namespace skyseal::ui {

SuiteRow::SuiteRow(QAction &action, QWidget *parent) : QRadioButton(parent), m_action(action)
{
    setAutoExclusive(false);
    setObjectName(QStringLiteral("row_") + action.objectName());
    connect(this, &QRadioButton::clicked, &action, &QAction::trigger);
    connect(&action, &QAction::changed, this, &SuiteRow::refresh);
    refresh();
}

void SuiteRow::refresh()
{
    setIcon(m_action.icon());
    setText(m_action.text());
    setAccessibleName(m_action.text());
    setEnabled(m_action.isEnabled());
    setChecked(m_action.isChecked());
    const QString keys = m_action.shortcut().toString(QKeySequence::NativeText);
    setToolTip(m_action.isEnabled() ? tr("%1 (%2)").arg(m_action.toolTip(), keys) : m_action.toolTip());
}

} // namespace skyseal::ui
