#include "ui/security/suite_row.h"

#include <QtGui/QAction>
#include <QtGui/QResizeEvent>

#include <algorithm>

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
    elide();
    setAccessibleName(m_action.text());
    setEnabled(m_action.isEnabled());
    setChecked(m_action.isChecked());
    const QString keys = m_action.shortcut().toString(QKeySequence::NativeText);
    setToolTip(m_action.isEnabled() && !keys.isEmpty() ? tr("%1 (%2)").arg(m_action.toolTip(), keys) : m_action.toolTip());
}

void SuiteRow::resizeEvent(QResizeEvent *event)
{
    QRadioButton::resizeEvent(event);
    elide();
}

void SuiteRow::elide()
{
    const QString shown = fontMetrics().elidedText(m_action.text(), Qt::ElideRight,
                                                   std::max(width(), minimumSizeHint().width()) - frameWidth());
    if (shown != text())
        setText(shown);
}

int SuiteRow::frameWidth() const
{
    return QRadioButton::sizeHint().width() - fontMetrics().size(Qt::TextShowMnemonic, text()).width();
}

QSize SuiteRow::minimumSizeHint() const
{
    const QString name = m_action.text().section(QStringLiteral(" · "), 0, 0);
    return {frameWidth() + fontMetrics().horizontalAdvance(name + QChar(0x2026)), QRadioButton::minimumSizeHint().height()};
}

} // namespace skyseal::ui

#include "moc_suite_row.cpp"
