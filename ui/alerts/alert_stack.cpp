#include "ui/alerts/alert_stack.h"

#include "ui/alerts/alert_row.h"
#include "ui/control_action.h"
#include "ui/text/plain_tip.h"
#include "ui/theme/grid.h"
#include "ui/theme/instrument_style.h"
#include "ui/theme/palettes.h"

#include <QtCore/QDateTime>
#include <QtGui/QKeyEvent>
#include <QtGui/QPainter>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr int kLeastWidth = 30 * kGrid, kMostWidth = 42 * kGrid;
constexpr int kRightMargin = 5 * kGrid; ///< leaves the map its north arrow

int lineHeight(const QWidget &widget)
{
    return std::max(3 * kGrid + kHalfGrid, leastTarget(widget));
}

} // namespace

AlertStack::AlertStack(QWidget &ground) : QFrame(ground.parentWidget()), m_ground(ground)
{
    setObjectName(QStringLiteral("alertStack"));
    setAccessibleName(tr("Alerts"));
    setAttribute(Qt::WA_OpaquePaintEvent); // the map below is not painted again for each of our numbers
    for (int i = 0; i < kMostShown; ++i) {
        AlertRow *row = m_rows[static_cast<std::size_t>(i)] = new AlertRow(i, this);
        row->hide();
        row->button()->installEventFilter(this);
        row->remedy()->installEventFilter(this);
        connect(row, &AlertRow::remedyRequested, this, &AlertStack::remedyRequested);
        connect(row, &AlertRow::dismissed, this, [this, i] { dismissRow(i); });
    }
    addAction(pressAction(*m_rows.front()->button(), Qt::CTRL | Qt::SHIFT | Qt::Key_Y));
    m_more = new QLabel(this);
    m_more->setObjectName(QStringLiteral("alertMore"));
    m_more->setTextFormat(Qt::PlainText);
    m_more->setIndent(kGrid + kHalfGrid);
    m_more->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_more->hide();
    ground.installEventFilter(this);
    hide();
    raise();
}

void AlertStack::showAlerts(std::vector<Alert> alerts, double now)
{
    m_now = now;
    if (alerts == m_alerts)
        return;
    m_alerts = std::move(alerts);
    arrange();
}

bool AlertStack::isHeld() const
{
    return isVisible() && (m_pointerInside || hasInnerFocus());
}

bool AlertStack::hasInnerFocus() const
{
    const QWidget *focused = QApplication::focusWidget();
    return focused && (focused == this || isAncestorOf(focused));
}

int AlertStack::mostShown() const
{
    const int lines = m_ground.height() / 2 / lineHeight(m_ground) - 1; // the last one is that of the number of the others
    return std::clamp(lines, 1, kMostShown);
}

void AlertStack::arrange()
{
    const auto most = static_cast<std::size_t>(mostShown());
    if (isHeld()) {
        for (auto &line : m_lines)
            if (line && std::ranges::find(m_alerts, *line, &Alert::id) == m_alerts.end())
                line.reset();
        for (const Alert &alert : m_alerts)
            if (m_lines.size() < most && std::ranges::find(m_lines, std::optional(alert.id)) == m_lines.end())
                m_lines.emplace_back(alert.id);
    } else {
        m_lines.clear();
        for (const Alert &alert : m_alerts)
            if (m_lines.size() < most)
                m_lines.emplace_back(alert.id);
    }
    fill();
}

void AlertStack::fill()
{
    const int focused = focusedRow();
    if (focused >= 0 && !m_lines.at(static_cast<std::size_t>(focused)))
        setFocus(); // the next key must not meet another alert
    int shown = 0;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        AlertRow &row = *m_rows[i];
        const bool used = i < m_lines.size();
        std::optional<Alert> alert;
        if (used && m_lines[i])
            alert = *std::ranges::find(m_alerts, *m_lines[i], &Alert::id);
        shown += alert ? 1 : 0;
        const QDateTime began = QDateTime::currentDateTime().addMSecs(alert ? qRound64((alert->since - m_now) * 1000) : 0);
        row.setAlert(alert, began.toString(QStringLiteral("HH:mm:ss")));
        row.setVisible(used);
    }
    showMore(static_cast<int>(m_alerts.size()) - shown);
    if (m_alerts.empty() && hasInnerFocus())
        returnFocus();
    place();
    setVisible(!m_alerts.empty());
}

/// The alerts that found no line; the shape is that of the worst among them.
void AlertStack::showMore(int hidden)
{
    m_more->setVisible(hidden > 0);
    if (hidden <= 0)
        return;
    QStringList texts;
    auto worst = AlertSeverity::Information;
    for (const Alert &alert : m_alerts) {
        if (std::ranges::find(m_lines, std::optional(alert.id)) != m_lines.end())
            continue;
        texts << alert.text;
        worst = std::max(worst, alert.severity);
    }
    const QString shape = worst == AlertSeverity::Information ? QString() : severityShape(worst) + QLatin1Char(' ');
    const QString text = shape + tr("and %1 more").arg(hidden);
    if (m_more->text() != text)
        m_more->setText(text);
    m_more->setToolTip(plainTip(texts.join(QStringLiteral(", "))));
}

void AlertStack::place()
{
    const int wanted = std::clamp(m_ground.width() * 2 / 3, kLeastWidth, kMostWidth);
    const int wide = std::clamp(m_ground.width() - kRightMargin - kGrid, 0, wanted);
    const int line = lineHeight(*this);
    int y = 1;
    for (std::size_t i = 0; i < m_lines.size(); ++i, y += line)
        m_rows[i]->setGeometry(1, y, wide - 2, line);
    if (!m_more->isHidden()) {
        m_more->setGeometry(1, y, wide - 2, line);
        y += line;
    }
    setGeometry(m_ground.x() + m_ground.width() - wide - kRightMargin, m_ground.y() + kGrid, wide, y + 1);
}

void AlertStack::dismissRow(int row)
{
    const auto line = static_cast<std::size_t>(row);
    if (line >= m_lines.size() || !m_lines[line])
        return;
    const AlertId id = *m_lines[line];
    if (focusedRow() == row)
        moveFocus(row, 1);
    Q_EMIT dismissed(id);
}

bool AlertStack::isDismiss(const QToolButton &button) const
{
    return std::ranges::any_of(m_rows, [&](const AlertRow *row) { return row->button() == &button; });
}

int AlertStack::focusedRow() const
{
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        if (m_rows[i]->button()->hasFocus() || m_rows[i]->remedy()->hasFocus())
            return static_cast<int>(i);
    return -1;
}

/// To the nearest line with an alert in the direction of `step`, else in the other one; else to the stack itself.
void AlertStack::moveFocus(int from, int step)
{
    for (const int direction : {step, -step}) {
        for (int i = from + direction; i >= 0 && i < static_cast<int>(m_lines.size()); i += direction) {
            if (m_lines[static_cast<std::size_t>(i)]) {
                m_rows[static_cast<std::size_t>(i)]->button()->setFocus(Qt::TabFocusReason);
                return;
            }
        }
    }
    setFocus();
}

void AlertStack::focusFirst()
{
    if (!isVisible())
        return;
    if (!hasInnerFocus())
        m_focusBefore = QApplication::focusWidget();
    moveFocus(-1, 1);
}

void AlertStack::returnFocus()
{
    QWidget *before = m_focusBefore && m_focusBefore->isVisible() ? m_focusBefore.data() : &m_ground;
    m_focusBefore = nullptr;
    before->setFocus();
}

void AlertStack::keyPressEvent(QKeyEvent *event)
{
    const int row = focusedRow();
    switch (event->key()) {
    case Qt::Key_Up: moveFocus(row < 0 ? static_cast<int>(m_lines.size()) : row, -1); return;
    case Qt::Key_Down: moveFocus(row, 1); return;
    case Qt::Key_Escape:
        if (event->isAutoRepeat())
            return;
        if (row >= 0)
            dismissRow(row);
        else
            returnFocus();
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!event->isAutoRepeat() && row >= 0)
            dismissRow(row);
        return;
    default: QFrame::keyPressEvent(event);
    }
}

bool AlertStack::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_ground) {
        if (event->type() == QEvent::Resize || event->type() == QEvent::Move)
            arrange();
    } else if (event->type() == QEvent::FocusOut) {
        focusOutEvent(static_cast<QFocusEvent *>(event));
    } else if (event->type() == QEvent::KeyPress) {
        auto *press = static_cast<QKeyEvent *>(event);
        switch (press->key()) { // a tool button takes the arrow keys as Tab
        case Qt::Key_Up:
        case Qt::Key_Down: keyPressEvent(press); return true;
        case Qt::Key_Left:
        case Qt::Key_Right: return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (auto *button = static_cast<QToolButton *>(watched); !isDismiss(*button)) {
                if (!press->isAutoRepeat())
                    button->click();
                return true;
            }
            break;
        default: break;
        }
    }
    return QFrame::eventFilter(watched, event);
}

void AlertStack::enterEvent(QEnterEvent *event)
{
    m_pointerInside = true;
    QFrame::enterEvent(event);
}

void AlertStack::leaveEvent(QEvent *event)
{
    m_pointerInside = false;
    QFrame::leaveEvent(event);
    arrange();
}

void AlertStack::focusOutEvent(QFocusEvent *)
{
    QMetaObject::invokeMethod(this, &AlertStack::arrange, Qt::QueuedConnection); // once the focus has arrived elsewhere
}

void AlertStack::hideEvent(QHideEvent *event)
{
    m_pointerInside = false;
    QFrame::hideEvent(event);
}

void AlertStack::paintEvent(QPaintEvent *)
{
    const StateColors &colors = stateColors(palette());
    QPainter painter(this);
    painter.fillRect(rect(), colors.panel);
    painter.setPen(colors.line);
    const int line = lineHeight(*this);
    for (int y = line; y < height() - kGrid; y += line)
        painter.drawLine(0, y, width(), y);
    painter.setPen(colors.edge);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

} // namespace skyseal::ui

#include "moc_alert_stack.cpp"
