#include "ui/alerts/alert_row.h"

#include "ui/text/plain_tip.h"
#include "ui/theme/grid.h"
#include "ui/theme/instrument_style.h"
#include "ui/theme/palettes.h"

#include <QtGui/QAccessible>
#include <QtGui/QPainter>
#include <QtWidgets/QToolButton>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr int kButton = 3 * kGrid + kHalfGrid;
constexpr int kShape = 3 * kGrid; ///< width of the column of shapes

} // namespace

QString severityShape(AlertSeverity severity)
{
    switch (severity) {
    case AlertSeverity::Severe: return QStringLiteral("▲");
    case AlertSeverity::Warning: return QStringLiteral("●");
    case AlertSeverity::Information: break;
    }
    return QStringLiteral("•");
}

QColor severityColor(AlertSeverity severity, const QPalette &palette)
{
    const StateColors &colors = stateColors(palette);
    switch (severity) {
    case AlertSeverity::Severe: return colors.alarm;
    case AlertSeverity::Warning: return colors.warning;
    case AlertSeverity::Information: break;
    }
    return palette.color(QPalette::WindowText);
}

AlertRow::AlertRow(int number, QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("alertRow%1").arg(number));
    m_remedy = new QToolButton(this); // before the other one, for the Tab key
    m_remedy->setObjectName(QStringLiteral("alertRemedy%1").arg(number));
    m_remedy->setText(tr("Pair…"));
    m_remedy->setAccessibleName(tr("Pair with the agent"));
    m_remedy->setFocusPolicy(Qt::TabFocus);
    m_remedy->hide();
    connect(m_remedy, &QToolButton::clicked, this, [this] {
        if (m_alert)
            Q_EMIT remedyRequested(m_alert->id);
    });
    m_dismiss = new QToolButton(this);
    m_dismiss->setObjectName(QStringLiteral("alertDismiss%1").arg(number));
    m_dismiss->setAccessibleName(tr("Dismiss the alert"));
    m_dismiss->setText(QStringLiteral("✕"));
    m_dismiss->setAutoRaise(true);
    m_dismiss->setFocusPolicy(Qt::TabFocus); // a click leaves the focus where it is
    connect(m_dismiss, &QToolButton::clicked, this, [this] {
        if (m_alert)
            Q_EMIT dismissed(m_alert->id);
    });
}

void AlertRow::setAlert(const std::optional<Alert> &alert, const QString &began)
{
    if (m_alert == alert)
        return;
    const bool isNew = alert && (!m_alert || m_alert->id != alert->id);
    m_alert = alert;
    m_dismiss->setVisible(alert.has_value());
    m_remedy->setVisible(alert && alert->id.kind == AlertKind::UnknownAgent);
    update();
    if (!alert) {
        setAccessibleName({});
        setToolTip({});
        return;
    }
    const QString word = alert->severity == AlertSeverity::Severe ? tr("Alarm")
        : alert->severity == AlertSeverity::Warning               ? tr("Warning")
                                                                  : tr("Information");
    setAccessibleName(tr("%1: %2").arg(word, alert->text));
    setAccessibleDescription(alert->details);
    setToolTip(plainTip(tr("%1 since %2: %3. %4").arg(word, began, alert->text, alert->details)));
    m_dismiss->setAccessibleName(tr("Dismiss: %1").arg(alert->text));
    m_dismiss->setToolTip(alert->ongoing ? tr("Dismiss until it recurs or gets worse (Esc)") : tr("Dismiss (Esc)"));
    if (isNew) {
        QAccessibleEvent event(this, QAccessible::Alert);
        QAccessible::updateAccessibility(&event);
    }
}

void AlertRow::resizeEvent(QResizeEvent *)
{
    const int side = std::max(kButton, leastTarget(*this));
    m_dismiss->setGeometry(width() - side - kHalfGrid, (height() - side) / 2, side, side);
    const int wide = m_remedy->sizeHint().width();
    m_remedy->setGeometry(m_dismiss->x() - wide - kHalfGrid, m_dismiss->y(), wide, side);
}

void AlertRow::paintEvent(QPaintEvent *)
{
    if (!m_alert)
        return;
    QPainter painter(this);
    const bool severe = m_alert->severity == AlertSeverity::Severe;
    const QColor color = isAttack(m_alert->id.kind) ? stateColors(palette()).alarm
                                                    : severityColor(m_alert->severity, palette());
    QFont strong = font();
    strong.setBold(severe);
    painter.setFont(strong);
    painter.setPen(color);
    painter.drawText(QRect(kHalfGrid, 0, kShape, height()), Qt::AlignCenter, severityShape(m_alert->severity));
    painter.setPen(severe ? color : palette().color(QPalette::WindowText));
    const QToolButton *first = m_remedy->isHidden() ? m_dismiss : m_remedy;
    const QRect place(kHalfGrid + kShape, 0, first->x() - kHalfGrid - kShape - kHalfGrid, height());
    painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(m_alert->text, Qt::ElideRight, place.width()));
}

} // namespace skyseal::ui

#include "moc_alert_row.cpp"
