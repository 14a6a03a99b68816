// One line of the alerts: shape, text, a button that deals with it where one does, and the button that dismisses it. Without an
// alert it only keeps its place. Lives on the GUI thread.
#pragma once

#include "ui/alerts/alert.h"

#include <QtWidgets/QWidget>

#include <optional>

class QToolButton;

namespace skyseal::ui {

class AlertRow : public QWidget
{
    Q_OBJECT

public:
    explicit AlertRow(int number, QWidget *parent);

    /// `began` is the wall-clock time for the tool tip. nullopt: no alert.
    void setAlert(const std::optional<Alert> &alert, const QString &began);
    const std::optional<Alert> &alert() const { return m_alert; }
    QToolButton *button() const { return m_dismiss; }
    QToolButton *remedy() const { return m_remedy; }

Q_SIGNALS:
    void dismissed(skyseal::ui::AlertId id);
    void remedyRequested(skyseal::ui::AlertId id);

protected:
    void paintEvent(QPaintEvent *) override;
    void resizeEvent(QResizeEvent *) override;

private:
    std::optional<Alert> m_alert;
    QToolButton *m_remedy, *m_dismiss;
};

/// "▲", "●" or "•": the shape that says the severity beside the colour.
QString severityShape(AlertSeverity severity);
QColor severityColor(AlertSeverity severity, const QPalette &palette);

} // namespace skyseal::ui
